# What does not fill all lanes is done by the last lane alone.
# expect: let the blocks be n / LANES, rounded up
# why: The remainder loop is a habit from vector code, where it costs little.
s/(n + LANES - 1) \/ LANES/n \/ LANES/
s/uint32_t i = k; i < n && lanes < LANES; i += block/uint32_t i = k; i < block * LANES \&\& lanes < LANES; i += block/
s/^    return lanes;/    if (k >= block) {\
        point[0] = block * LANES + k - block;\
        column[0] = cell[point[0]] * LANES + LANES - 1;\
        return 1;\
    }\
&/
s/k < block; k++/k < block + n % LANES; k++/
s/i < block \* LANES && lanes < LANES/k < block \&\& &/
