# Stops one round before the longest has finished.
# expect: one of the longest
# why: Rounds are counted from 0 or from 1.
s/for (uint32_t b = 1; b <= longest/for (uint32_t b = 1; b < longest/
