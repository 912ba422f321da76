# There is a reading for each histogram.
# expect: one reading counts all four
# why: A function for a pass contains everything that the pass needs.
/uint32_t count/,/int from/{
s/for (uint32_t i = 0; i < n; i++) {/for (int k = 0; k < BYTES; k++) &/
s/++;/ += b == k;/
}
