# Leaves the merged ones as they are.
# expect: but not in order
# why: The right eight are found, and the text wanted them in order.
s/for (uint32_t q = k \/ 2; q >= 1; q \/= 2)/for (uint32_t q = k \/ 2; q > 1; q \/= 2)/
