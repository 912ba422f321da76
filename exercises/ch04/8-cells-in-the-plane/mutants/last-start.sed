# The scan ends with the last cell.
# expect: where the last cell ends
# why: There are as many starts as cells, it seems.
s/k <= cells; k++/k < cells; k++/
