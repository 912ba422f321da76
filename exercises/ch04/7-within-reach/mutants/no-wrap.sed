# The grid ends at the border of the box.
# expect: across the border of the box
# why: The half block is found first for a plain box, and the box stays plain.
s/^ *uint32_t c = (column/if (column + 1 == columns \&\& steps[s][0] == 1) continue; &/
