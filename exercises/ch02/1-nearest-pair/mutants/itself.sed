# The inner loop begins at the point itself.
# expect: a point is not its own neighbor
s/j = i + 1;/j = i;/
