# The row of a query is found again and again.
# expect: Are queries compared with each other
# why: The sort that they know compares, and each comparison finds two rows.
s/end\[row_at(y\[q\])\]++;/for (int p = 0; p < 9; p++) row_at(y[q]); &/; s/row_at(y\[q\]); end/row_at(y[q]); end/
s/^    for (uint32_t q = 0; q < n; q++)$/& {/; s/\(row_at(y\[q\])\]++;\)/\1 }/
