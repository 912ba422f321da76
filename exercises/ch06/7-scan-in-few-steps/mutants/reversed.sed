# Joins the wrong way round.
# expect: The left sum comes first
# why: Sums of numbers do not mind, and they tried numbers.
s/join(to\[i\], from\[2 \* i\])/join(from[2 * i], to[i])/
