# Compares a way with a square.
# expect: both numbers squared
# why: All that is compared looks like a distance.
s/    if (search->way\[0\] \* search->way\[0\] +/    if (search->way[0] +/;s/            search->way\[1\] \* search->way\[1\] <$/            search->way[1] </
