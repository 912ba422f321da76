# For an odd n the last value is compared with one that does not exist.
# expect: there is no value
# why: The same, but the loop takes a partner that is not there, and on their own data nothing happens.
s/uint32_t i = n % 2;/uint32_t i = 0;/
