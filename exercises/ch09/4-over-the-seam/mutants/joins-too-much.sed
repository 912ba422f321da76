# Joins the stretches of a row.
# expect: A stretch of columns ends
# why: Both belong to one row, and a row was one span.
s/spans\[n - 1\].end == begin/spans[n - 1].end + 4 >= begin/
