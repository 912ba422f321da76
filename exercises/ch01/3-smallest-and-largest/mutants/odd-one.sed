# For an odd n the last value is never compared.
# expect: odd
# why: They think of pairs and try an even number of values.
s/uint32_t i = n % 2; i < n;/uint32_t i = 0; i + 1 < n;/
