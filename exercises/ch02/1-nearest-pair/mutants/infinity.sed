# The search begins with infinity, which an infinite distance cannot beat.
# expect: begin with a pair
# why: It is the usual beginning of every search for a minimum, and was right in all of them so far.
s/best = {0, 1, between(points, 0, 1)}/best = {.distance2 = INFINITY}/
