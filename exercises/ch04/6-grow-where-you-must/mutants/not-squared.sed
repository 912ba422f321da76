# A distance is compared with a squared one.
# expect: square the distance to the border
# why: The gap is a distance, the best so far is a square, and with cells of side 1 the mistake may hide.
s/gap \* gap > best/gap > best/
