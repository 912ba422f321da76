# The loops end one point too early.
# expect: Is the last point ever looked at?
s/j < points.n/j < points.n - 1/
