# The layer ends at the edge although the grid wraps around.
# expect: reached across it
# why: The plain grid comes first, and the flag is read nowhere.
s|if (wraps)|if (wraps \&\& count == 0)|
