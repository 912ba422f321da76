# Squares.
# expect: as little as possible
# why: They crowd as well.
s/x\[k\] = power/x[k] = (double)k * k \/ ((double)n * n)/
