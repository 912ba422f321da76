# Stops one step before the longest has finished.
# expect: one of the longest
s/for (uint32_t b = 1; b <= longest/for (uint32_t b = 1; b < longest/
