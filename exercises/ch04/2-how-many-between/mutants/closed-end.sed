# The comparison counts what equals the bound.
# expect: the other way round
s/look(s) < x/look(s) <= x/; s/if (x == bins->border\[k\])/if (0)/
