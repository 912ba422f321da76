# Forgets what comes before the pair.
# expect: does not begin with the first element
s/join(to\[i\], from\[2 \* i\])/from[2 * i]/
