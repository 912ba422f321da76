# The places begin behind the byte's own records.
# expect: its own do not count
# why: An inclusive sum, that is, the end of each byte in place of its beginning.
s/count\[v\] = sum;//
s/sum += here;/count[v] = sum += here;/
