# The arrays are thought to have one element more.
# expect: which has
s/uint32_t place = found < k ? found++ : k - 1;/uint32_t place = found <= k ? found++ : k;/
