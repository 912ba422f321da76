# Finds the lower side only.
# expect: A corner of the upper side is missing
# why: The stack ends at the rightmost point, and a picture of few points looks right.
s/for (uint32_t s = m - 1; s-- > 0;)/for (uint32_t s = 1; s-- > 0;)/
