# Asks whether the first begins before the second ends.
# expect: They do not meet along x
# why: The two arguments look alike.
s/begins_within(order\[r\], order\[s\])/begins_within(order[s], order[r])/
