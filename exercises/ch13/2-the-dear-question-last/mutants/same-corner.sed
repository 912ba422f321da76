# Compares the first corner with the first, the second with the second.
# expect: need not be the same corner
# why: One loop over the corners looks like enough.
s/a\[i\] == b\[0\] || a\[i\] == b\[1\] || a\[i\] == b\[2\]/a[i] == b[i]/
