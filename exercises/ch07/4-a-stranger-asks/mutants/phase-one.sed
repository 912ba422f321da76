# The nearest of phase one is the answer.
# expect: nearest of phase one
s|square2 = best.nearest2;|square2 = -1;|
