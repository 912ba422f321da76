# The next place is never moved on.
# expect: move on when one is taken
s/place\[l\]++;/place[l] += 0;/
