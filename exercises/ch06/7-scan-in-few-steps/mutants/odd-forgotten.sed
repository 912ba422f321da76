# Halves an odd number downward.
# expect: If n is odd
# why: n / 2, rounded down, as everywhere.
s/(n + 1) \/ 2/n \/ 2/
s/i < half - 1;/i + 1 < half;/
