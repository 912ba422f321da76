# Counts the bits of a byte from the highest.
# expect: from the lowest bit on
# why: On paper the first bit of a number stands at the left.
s/keep\[i \/ 8\] >> i % 8/keep[i \/ 8] >> (7 - i % 8)/
