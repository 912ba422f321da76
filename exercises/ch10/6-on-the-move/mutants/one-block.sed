# Stops after nine cells, if there is anybody.
# expect: lies beyond the cells that were searched
# why: It is the block of chapter 4, without the border test.
s/if (certain > 0 \&\& best.d2 < certain \* certain)/if (reach > 0 \&\& best.nearest != NONE)/
