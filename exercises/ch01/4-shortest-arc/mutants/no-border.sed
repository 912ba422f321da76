# The gap across the border is not among the gaps.
# expect: across the border
# why: They loop over neighbors in the sorted array, of which there are $n - 1$, and the circle has $n$ gaps.
s/widest = sorted\[0\] + 1 - sorted\[n - 1\]/widest = 0/
