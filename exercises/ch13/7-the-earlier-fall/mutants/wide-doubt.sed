# Doubts what differs by a part in a thousand million.
# expect: Sum up the roundings
# why: It is on the safe side, and small.
s/4 \* 0x1p-53 \* (of_p + of_q)/1e-9 * (of_p + of_q)/
