# It leaves out a byte only if it is 0 in all keys.
# expect: All keys may agree in another value
s/count\[b\]\[byte(key, b)\] < n/count[b][0] < n/
