# Keeps the first one met in a lane.
# expect: in the same lane
s/(d2 == best->distance2\[l\])/0/
