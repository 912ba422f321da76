# All lanes share one count for a cell.
# expect: Two lanes share a count
# why: It is the first half of the chapter.
s/cell\[i\] \* LANES + lanes/cell[i]/
