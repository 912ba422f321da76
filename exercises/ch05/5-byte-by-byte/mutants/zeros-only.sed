# It leaves out a byte only if it is 0 in all keys.
# expect: All keys may agree in another value
# why: They think of small keys, in which the upper bytes are 0.
s/count\[b\]\[byte(key, b)\] < n/count[b][0] < n/
