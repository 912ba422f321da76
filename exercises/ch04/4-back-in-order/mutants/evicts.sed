# The point in the next slot of the cell must go, at home or not.
# expect: were at home were sent away
# why: They treat the next slot as free, which it is in a sort with a second array.
/while (cell_of(home\[c\]) == c)/,+1d
