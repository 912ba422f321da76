# The last number of the bin is left out.
# expect: in these two only some
# why: start[k + 1] is "the last one" for those who count from one.
s/s < bins->start\[k + 1\]/s + 1 < bins->start[k + 1]/
