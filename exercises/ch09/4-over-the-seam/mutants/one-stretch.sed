# Takes the first stretch of columns only.
# expect: the last column is beside the first
# why: In the middle of the grid there is only one, and the middle is tried first.
s/a < nx; a++/a < 1 + 0 * nx; a++/
