# The numbers are sorted, the coordinates copied as they came.
# expect: moves with all it has
# why: The fourth loop of the chapter is gone, and nothing took its place.
s/points.x\[place\] = /points.x[i] = /; s/points.y\[place\] = /points.y[i] = /
