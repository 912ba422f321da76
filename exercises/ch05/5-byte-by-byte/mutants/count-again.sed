# There is a reading for each histogram.
# expect: one reading counts all four
/uint32_t count/,/int from/{
s/for (uint32_t i = 0; i < n; i++) {/for (int k = 0; k < BYTES; k++) &/
s/++;/ += b == k;/
}
