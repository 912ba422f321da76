# Lets points stray by a whole cell.
# expect: A wide margin has the search go on
# why: The wider, the fewer are put, and only that is counted.
s/margin = 0.125/margin = 1.0/
