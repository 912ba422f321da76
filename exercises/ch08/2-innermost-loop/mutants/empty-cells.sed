# Takes a step before it asks.
# expect: An empty cell has no first point
# why: In Su's program empty cells have been packed away before, and the text says that here they are not.
s/^    keep_unfinished(strip, start, 0);//
