# The last candidate is not looked at.
# expect: is it looked at
# why: A bound copied from a loop that runs to n - 1.
s/j < to.n/j + 1 < to.n || j == 0/
