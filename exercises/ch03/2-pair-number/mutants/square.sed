# The rows of a full square.
# expect: full square
s/return (uint64_t)i \* (2.*/return (uint64_t)i * n + j;/
