# Leaves out the upper border.
# expect: equal to the upper border
# why: The intervals of the lecture are half open.
s/place_of(axis, n, high\[axis\], 1)/place_of(axis, n, high[axis], 0)/
