# All lanes share one count for a cell.
# expect: Two lanes share a count
s/cell\[i\] \* LANES + lanes/cell[i]/
