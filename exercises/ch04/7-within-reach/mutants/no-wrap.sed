# The grid ends at the border of the box.
# expect: across the border of the box
s/^ *uint32_t c = (column/if (column + 1 == columns \&\& steps[s][0] == 1) continue; &/
