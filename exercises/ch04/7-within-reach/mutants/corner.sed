# One corner is forgotten.
# expect: touch at a corner
s/s < 4; s++/s < 3; s++/
