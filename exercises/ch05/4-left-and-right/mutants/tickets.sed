# Every point draws the next place from a counter, atomically.
# expect: they took their places as they came
# why: An atomic counter never gives a place twice, and the order is not looked at.
s/^uint32_t divide/static uint32_t next[2];\
&/
s/lefts = left\[all\];/& next[0] = 0; next[1] = lefts;/
s/uint32_t l = left\[t\], r = .*/uint32_t l, r;/
s/point\[l++\] = i;/{ _Pragma("omp atomic capture") l = next[0]++; point[l] = i; }/
s/point\[r++\] = i;/{ _Pragma("omp atomic capture") r = next[1]++; point[r] = i; }/
