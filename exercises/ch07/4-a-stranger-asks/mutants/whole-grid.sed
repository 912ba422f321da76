# Phase two looks at everything.
# expect: only if its column and its row both
s|square2 = best.nearest2;|square2 = 1e300;|
