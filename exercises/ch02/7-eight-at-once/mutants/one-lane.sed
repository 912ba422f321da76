# One lane: the plain loop again.
# expect: A single best is a chain
# why: The arrays of lanes are there, but each group has one query.
s/LANES = 8/LANES = 1/
