# Lets all tasks work until the longest has finished.
# expect: as many lanes in the last step
# why: The tasks are in the right order, and the number of lanes is forgotten.
s/step(places\[b\], order)/step(n, order)/
