# The point is among its own neighbors.
# expect: not its own neighbor
# why: The loop over all points is copied without its condition.
s/j == i/j == points.n/
