# The way back takes away what the way there has left.
# expect: the way back took away
# why: The second loop is a copy of the first one, and "at least two on the stack" with it.
s/count, lower, order/count, 1, order/
