# Bins count as a whole.
# expect: These are whole bins
# why: It is the starter, with the ends repaired.
s/if (x == bins->border\[k\])/if (1)/
