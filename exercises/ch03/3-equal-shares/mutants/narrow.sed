# The number of all pairs is computed in 32 bits.
# expect: 32 bits
# why: Five billion is a number that one does not expect from a hundred thousand.
s/(uint64_t)n \* (n - 1) \/ 2/(uint64_t)(n * (n - 1) \/ 2)/
