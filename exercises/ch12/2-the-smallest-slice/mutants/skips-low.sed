# Leaves out the lower border.
# expect: equal to the lower border
# why: Both searches are the same, so both ask for above.
s/place_of(axis, n, low\[axis\], 0)/place_of(axis, n, low[axis], 1)/
