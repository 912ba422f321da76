# The layer ends at the edge although the grid wraps around.
# expect: reached across it
s|if (wraps)|if (wraps \&\& count == 0)|
