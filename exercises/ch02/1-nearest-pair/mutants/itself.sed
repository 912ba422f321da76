# The inner loop begins at the point itself.
# expect: a point is not its own neighbor
# why: They copy the naive search, where the loop runs over all points and skips one, and take over the beginning without the skipping.
s/j = i + 1;/j = i;/
