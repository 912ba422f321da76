# The comparison is the wrong way round.
# expect: furthest pair
# why: A sign of haste; it is good to see that the message says it in one word.
s/d2 < best/d2 > best/
