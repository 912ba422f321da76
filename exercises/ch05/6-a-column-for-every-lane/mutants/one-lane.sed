# One lane does it all.
# expect: Only one lane works at a time
# why: It is right, and the tests of answers do not object.
s/uint32_t block = .*, lanes = 0;/uint32_t block = n, lanes = 0;/
s/uint32_t block = (n + LANES - 1) \/ LANES;/uint32_t block = n;/
