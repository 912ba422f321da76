# The sums contain the cell itself.
# expect: This is where the cell ends
s/start\[cell_of(s) + 1\]++/start[cell_of(s)]++/
