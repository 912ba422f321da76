# The next four begin too near.
# expect: wherever they lie
# why: They leave a cell between two fours, and forget that the pair's own distance is more than that.
s/= 3 \* (four %/= 2 * (four %/
