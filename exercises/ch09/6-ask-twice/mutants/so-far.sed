# Compares with the smallest so far.
# expect: smallest so far
# why: One pass is faster than two.
/least2 = scratch\[s\] </d
s/^        if (scratch\[s\] > limit/        least2 = scratch[s] < least2 ? scratch[s] : least2;\n        limit = sqrt(least2) + 0x1p-22;\n&/
