# The rows of a full square.
# expect: full square
# why: They number the cells of a full matrix, of which the triangle is one half.
s/return (uint64_t)i \* (2.*/return (uint64_t)i * n + j;/
