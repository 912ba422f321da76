# Ends one step too late, as the printed figure can be read.
# expect: one step too many
# why: They follow the printed figure, in which the test comes after the measure and counts from 0.
s/strip->keep\[l\] = step <.*/strip->keep[l] = step <= start[cell + 1] - start[cell];/
