# The block grows beyond the last column.
# expect: reached the edge
# why: The border of the last column exists in the array, so nothing stops them from asking for it.
s/b.right + 1 < grid->columns/b.right < grid->columns/
