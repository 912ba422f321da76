# Phase two looks at everything.
# expect: only if its column and its row both
# why: The square is a refinement, and the answers do not need it.
s|square2 = best.nearest2;|square2 = 1e300;|
