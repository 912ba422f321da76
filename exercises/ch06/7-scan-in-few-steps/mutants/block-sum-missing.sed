# Forgets what comes before the pair.
# expect: does not begin with the first element
# why: Each block is scanned by itself, and with one block that is all.
s/join(to\[i\], from\[2 \* i\])/from[2 * i]/
