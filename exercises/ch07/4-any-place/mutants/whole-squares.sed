# Every layer is looked at with all that is inside.
# expect: Each layer is a ring
# why: A layer is a ring, but a square is one loop less.
s|r == row - k .. r == row + k ? 1 : 2 \* k|1|
