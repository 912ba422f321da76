# Takes a step before it asks.
# expect: An empty cell has no first point
s/^    keep_unfinished(strip, start, 0);//
