# Leaves out what is not four points.
# expect: one of the last of its span
# why: The remainder is postponed, as in all loops over vectors.
s/place < span\[s\].end;/place + LANES <= span[s].end;/
