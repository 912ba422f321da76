# Keeps right turns.
# expect: turn
# why: With y downward, as on a screen, it would be right.
s/turn(points, corner\[count - 2\], corner\[count - 1\], j) <= 0/turn(points, corner[count - 2], corner[count - 1], j) >= 0/
