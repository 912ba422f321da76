# Where dx alone is as long as the best distance, it measures all the same.
# expect: cannot win
# why: "Greater" seems the safe side, and it is, for the answers.
s/dx \* dx >= nearest2/dx * dx > nearest2/
