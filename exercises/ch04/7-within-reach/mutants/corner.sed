# One corner is forgotten.
# expect: touch at a corner
# why: Of four steps, one is a diagonal to the left, and that looks like one of the other half.
s/s < 4; s++/s < 3; s++/
