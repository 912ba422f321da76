# Walks to the first place.
# expect: Search by halves
# why: A loop is easier to get right.
s/const uint32_t middle = low + (high - low) \/ 2;/const uint32_t middle = low;/
