# dx without its square: to the left of the point, nothing is too far.
# expect: Points to the left
s/dx \* dx >= nearest2/dx >= sqrt(nearest2)/
