# Joins the wrong way round.
# expect: The left sum comes first
s/join(to\[i\], from\[2 \* i\])/join(from[2 * i], to[i])/
