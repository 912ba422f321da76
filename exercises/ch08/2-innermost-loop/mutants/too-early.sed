# Is done one point too early.
# expect: the last one of its cell
# why: They compare the number of the next step with the last index, not with the count.
s/start, step + 1/start, step + 2/
