# The numbers are sorted, the coordinates copied as they came.
# expect: moves with all it has
# why: The fourth loop of the chapter is gone, and nothing took its place.
s/sorted->x\[place\] = /sorted->x[i] = /; s/sorted->y\[place\] = /sorted->y[i] = /
