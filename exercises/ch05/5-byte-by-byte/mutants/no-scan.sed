# The places begin behind the byte's own records.
# expect: its own do not count
s/count\[v\] = sum;//
s/sum += here;/count[v] = sum += here;/
