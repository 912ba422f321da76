# The gap across the border is not among the gaps.
# expect: across the border
s/widest = sorted\[0\] + 1 - sorted\[n - 1\]/widest = 0/
