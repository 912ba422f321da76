# One layer more, and that is it.
# expect: One layer more is not always enough
s|square2 = best.nearest2;|square2 = best.nearest2, last = k + 2;|
