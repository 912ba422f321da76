# The last number of the bin is left out.
# expect: in these two only some
s/s < bins->start\[k + 1\]/s + 1 < bins->start[k + 1]/
