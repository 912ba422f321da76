# Leaves out what is not four points.
# expect: one of the last of its span
s/place < span\[s\].end;/place + LANES <= span[s].end;/
