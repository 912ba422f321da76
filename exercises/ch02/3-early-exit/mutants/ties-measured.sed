# Where dx alone is as long as the best distance, it measures all the same.
# expect: cannot win
s/dx \* dx >= nearest2/dx * dx > nearest2/
