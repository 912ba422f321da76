# The product is computed in 32 bits.
# expect: 32 bits
# why: The result is 64 bits wide, so they take the product to be, too.
s/(uint64_t)i \* (2 \* (uint64_t)n - i - 1)/i * (2 * n - i - 1)/
