# The number of all pairs is computed in 32 bits.
# expect: 32 bits
s/(uint64_t)n \* (n - 1) \/ 2/(uint64_t)(n * (n - 1) \/ 2)/
