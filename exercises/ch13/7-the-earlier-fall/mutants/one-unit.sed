# Allows for a single rounding of the sum.
# expect: It is sure, and wrong
# why: The last operation is rounded once, and random near ties seldom need more.
# points: 7
s/4 \* 0x1p-53/0x1p-53/
