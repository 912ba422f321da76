# Begins at the left edge.
# expect: needs room to its left
# why: The first step goes to the right, so the walk seems to begin at the left.
/x += step\[s\].b; /,+0s/x += /x += 0 * /
