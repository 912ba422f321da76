# Leaves out the last inner cell.
# expect: left out
# why: The end of a stretch is the start of the next cell.
s/count += start\[last\] - start\[first + 1\];/count += start[last - 1] - start[first + 1];/
