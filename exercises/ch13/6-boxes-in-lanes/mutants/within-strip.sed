# Writes numbers within the strip.
# expect: does not meet the box
# why: The second loop counts from 0.
s/found\[count\] = i;/found[count] = i - first;/
s/STRIP = 128/STRIP = 32/
