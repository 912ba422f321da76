# Two columns are treated like many.
# expect: has the same neighbor on the left
s/count < 3 ? 1/count < 2 ? 1/
