# The sums contain the cell itself.
# expect: This is where the cell ends
# why: An inclusive scan in place of an exclusive one; both are called prefix sums.
s/start\[cell_of(s) + 1\]++/start[cell_of(s)]++/
