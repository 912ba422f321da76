# is_left is called once more for those on the right.
# expect: Once to count and once to place is enough
# why: A second loop for the right half is the easiest to write.
s/^            else$/            else if (!is_left(i))/
