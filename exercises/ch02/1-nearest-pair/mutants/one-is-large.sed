# The search begins with 1, as if nothing could be further apart.
# expect: No pair beat what the search began with
s/INFINITY/1/
