# One layer more, and that is it.
# expect: One layer more is not always enough
# why: It is the rule of the first search of the chapter, and right for nearly all points.
s|square2 = best.nearest2;|square2 = best.nearest2, last = k + 2;|
