# The pair lies in columns that touch.
# expect: wherever they lie
# why: They think of a pair across a border, but the block has that column, too.
s/2\.1, 0\.9, 2\.1/1.7, 0.9, 1.7/
