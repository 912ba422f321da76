# The comparison counts what equals the bound.
# expect: the other way round
# why: Less or less-or-equal: one of the two ends of a half-open interval is always written the wrong way first.
s/look(s) < x/look(s) <= x/; s/if (x == bins->border\[k\])/if (0)/
