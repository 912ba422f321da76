# Leaves out the highest bit.
# expect: highest bit was left out
# why: Bits are numbered from 0, and the last one is bits - 1.
s/k < bits;/k < bits - 1;/
