# For an odd n the last value is compared with one that does not exist.
# expect: there is no value
s/uint32_t i = n % 2;/uint32_t i = 0;/
