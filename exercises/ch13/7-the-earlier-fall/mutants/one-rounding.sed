# Counts no rounding but the last.
# expect: It is sure, and wrong
# why: It is the last operation that is looked at.
s/4 \* 0x1p-53 \* (of_p + of_q)/0.5 * 0x1p-53 * fabs(of_p - of_q)/
