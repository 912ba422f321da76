# The search begins with 1, as if nothing could be further apart.
# expect: No pair beat what the search began with
# why: All their points were in the unit square, where hardly two are as far apart.
s/best = {0, 1, between(points, 0, 1)}/best = {.distance2 = 1}/
