# Whoever stands in the next slot of the cell must go, at home or not.
# expect: were at home were sent away
/while (cell_of(home\[c\]) == c)/,+1d
