# The search begins with a billion, as if nothing could be further apart.
# expect: No pair beat what the search began with
s/best = {0, 1, between(points, 0, 1)}/best = {0, 1, 1e9}/
