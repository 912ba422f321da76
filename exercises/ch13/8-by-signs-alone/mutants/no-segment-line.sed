# Does not try the line along the segment.
# expect: or along the segment, has them apart
# why: The triangle's edges are where the loop is.
s/return sum != 3 && sum != -3;/return sum < 10;/
