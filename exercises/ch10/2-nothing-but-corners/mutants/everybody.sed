# Measures all points.
# expect: Only corners need be measured
# why: It is the search of chapter 2, and always right.
s/c < count; c++/c < points.n; c++/
s/uint32_t j = corner\[c\];/uint32_t j = c;/
