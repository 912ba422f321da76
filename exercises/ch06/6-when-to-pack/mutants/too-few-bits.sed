# Multiplies in 32 bits.
# expect: convert before you multiply
# why: Both factors are 32 bits wide, and so is the product, in C.
s/(uint64_t)price/price/
