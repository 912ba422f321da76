# Keeps the distance and not the index.
# expect: kept or replaced together
# why: A minimum of the distances is one instruction, and the index needs a second thought.
/best->index\[l\] = better/s/best->index\[l\] = better ? j : /best->index[l] = best->distance2[l] == d2 \&\& best->index[l] == NO_INDEX ? j : /
