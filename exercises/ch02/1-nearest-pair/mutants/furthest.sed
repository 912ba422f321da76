# The comparison is the wrong way round.
# expect: furthest pair
s/d2 < best/d2 > best/
