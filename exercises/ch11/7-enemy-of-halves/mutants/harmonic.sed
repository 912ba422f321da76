# One over k.
# expect: as little as possible
# why: It crowds at 0, too, but not enough.
s/x\[k\] = power/x[k] = 1.0 \/ (k + 1)/
