# The search begins with infinity, which an infinite distance cannot beat.
# expect: begin with a pair
s/best = {0, 1, between(points, 0, 1)}/best = {.distance2 = INFINITY}/
