# It asks once more for those on the right.
# expect: Once to count and once to place is enough
s/^            else$/            else if (!is_left(i))/
