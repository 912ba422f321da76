# Phase two looks at everything.
# expect: When may the search stop
# why: The square is a refinement, and the answers do not need it.
s|square2 = best.nearest2;|square2 = 1e300;|
