# Goes on while the next corner is not lower, if there are three.
# expect: the first of them was passed by
# why: It does not end for two corners, so these become a special case, and the comparison stays.
s/height(i, (k + 1) % n) > height(i, k)/height(i, (k + 1) % n) - height(i, k) >= (n < 3)/
