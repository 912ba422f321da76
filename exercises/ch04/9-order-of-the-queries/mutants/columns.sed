# The queries are sorted from left to right.
# expect: Queries of one row want the same points
# why: Sorted by x sounds like an order of the rows.
s/row_at(y\[q\])/row_at(x[q])/
