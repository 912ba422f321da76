# Keeps points along the sides.
# expect: is no corner: the band does not bend there
# why: They take "does not turn left" for "turns right", and forget the third case.
s/corner\[count - 1\], j) <= 0/corner[count - 1], j) < 0/
