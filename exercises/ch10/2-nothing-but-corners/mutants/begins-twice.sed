# Counts the first corner at the end once more.
# expect: the first corner
# why: The way back ends where the way there began, and the loop looks complete.
s/: count - 1;/: count;/
