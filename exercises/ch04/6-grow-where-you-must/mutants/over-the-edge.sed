# The block grows beyond the last column.
# expect: reached the edge
s/b.right + 1 < grid->columns/b.right < grid->columns/
