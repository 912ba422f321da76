# Keeps the first one found in a lane.
# expect: in the same lane
# why: Inside a lane points seem to come in order, as they did before the sort.
s/(d2 == best->distance2\[l\])/0/
