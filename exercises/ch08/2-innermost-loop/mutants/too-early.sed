# Is done one point too early.
# expect: the last one of its cell
s/start, step + 1/start, step + 2/
