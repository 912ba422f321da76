# Leaves out the highest bit.
# expect: highest bit was left out
s/k < bits;/k < bits - 1;/
