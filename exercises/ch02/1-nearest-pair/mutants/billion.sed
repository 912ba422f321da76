# The search begins with a billion, as if nothing could be further apart.
# expect: No pair beat what the search began with
# why: It is larger than any distance that they have ever seen on the screen.
s/best = {0, 1, between(points, 0, 1)}/best = {0, 1, 1e9}/
