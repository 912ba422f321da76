# The point is among its own neighbors.
# expect: not its own neighbor
s/j == i/j == points.n/
