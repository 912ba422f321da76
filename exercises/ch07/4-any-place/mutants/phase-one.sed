# The nearest of phase one is the answer.
# expect: nearest of phase one
# why: They stop when they have found somebody.
s|square2 = best.nearest2;|square2 = -1;|
