# Multiplies in 32 bits.
# expect: convert before you multiply
s/(uint64_t)price/price/
