# Bounds by the last cut alone.
# expect: add up the ways
# why: One cut, one bound.
s/    if (search->way\[0\] \* search->way\[0\] +/    if (search->way[axis] * search->way[axis] </;/            search->way\[1\] \* search->way\[1\] <$/d
