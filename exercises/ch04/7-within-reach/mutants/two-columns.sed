# Two columns are treated like many.
# expect: has the same neighbor on the left
# why: They think of a grid of many columns, as in every picture.
s/count < 3 ? 1/count < 2 ? 1/
