# Lets all tasks work until the longest has finished.
# expect: as many lanes in the last round
# why: The tasks are in the right order, and the number of lanes is forgotten.
s/make_round(places\[b\], order)/make_round(n, order)/
