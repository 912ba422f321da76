# A query's number stays behind.
# expect: not to its place in the order
# why: The coordinates are what the search needs, and the number is remembered when it is too late.
s/{x\[q\], y\[q\], q}/{x[q], y[q], end[row_at(y[q])]}/
