# The comparison is the wrong way round.
# expect: furthest pair
s/INFINITY/0/
s/d2 < best/d2 > best/
