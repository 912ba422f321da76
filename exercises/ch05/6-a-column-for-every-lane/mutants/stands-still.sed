# The next place is never moved on.
# expect: move on when one is taken
# why: They take the scan for the places of all points, not of the first one.
s/place\[l\]++;/place[l] += 0;/
