# Allows for 2.5 roundings of the sum.
# expect: It is sure, and wrong
# why: Roundings do not all go the same way, one thinks; here they do.
# points: 7
s/4 \* 0x1p-53/2.5 * 0x1p-53/
