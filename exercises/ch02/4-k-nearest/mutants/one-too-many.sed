# The arrays are thought to have one element more.
# expect: which has
# why: An insertion sort that they know has a free place at the end, and here there is none.
s/uint32_t place = found < k ? found++ : k - 1;/uint32_t place = found <= k ? found++ : k;/
