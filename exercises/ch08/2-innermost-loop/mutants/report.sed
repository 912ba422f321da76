# Ends one step too late, as the printed figure can be read.
# expect: one step too many
s/strip->keep\[l\] = step <.*/strip->keep[l] = step <= start[cell + 1] - start[cell];/
