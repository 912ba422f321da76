# Doubts what is less than an absolute bound.
# expect: It is sure, and wrong
# why: A tolerance is a small number, and 1e-12 is one.
s/4 \* 0x1p-53 \* (of_p + of_q)/1e-12/
