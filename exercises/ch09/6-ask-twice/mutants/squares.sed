# Adds the bound to the square.
# expect: one for distances
# why: Distances are squared in this book, so the bound is added to what there is.
s/scratch\[s\] > limit \* limit/scratch[s] > least2 + 0x1p-22/
