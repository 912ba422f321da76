# Compares two axes.
# expect: along all three axes
# why: The line for the third was not copied.
s/(low_z\[i\] <= b.high\[2\]) & (high_z\[i\] >= b.low\[2\])/1 | (low_z[i] > high_z[i])/
