# A squared distance is compared with r.
# expect: compare it with the square of r
# why: It is how the starter compares.
s/measure(i, j) < r \* r/measure(i, j) < r/
