# Adds the bound to the square.
# expect: one for distances
s/scratch\[s\] > limit \* limit/scratch[s] > least2 + 0x1p-22/
