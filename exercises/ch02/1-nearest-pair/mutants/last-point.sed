# The loops end one point too early.
# expect: Is the last point ever looked at?
# why: The outer loop may stop one earlier, so they stop both.
s/j < points.n/j < points.n - 1/
