# The border is taken for a wall.
# expect: not a wall
# why: This is the box of the standard geometry, and it is right on every set that keeps away from the border.
s/start = sorted\[i\];//
s/return (struct arc){start, 1 - widest}/return (struct arc){start, last - start}/
s/free(sorted);/double last = sorted[n - 1]; free(sorted); (void)widest;/
