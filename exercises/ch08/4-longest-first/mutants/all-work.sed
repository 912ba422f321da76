# Lets everybody work until the longest has finished.
# expect: as many lanes in the last step
s/step(places\[b\], order)/step(n, order)/
