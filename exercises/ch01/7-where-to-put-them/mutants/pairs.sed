# Pairs of coordinates.
# expect: combed apart
# why: It is the layout of all other books.
s/return line \* LINE.*/return (2 * (size_t)i + axis) * sizeof(double) + 0 * line;/
