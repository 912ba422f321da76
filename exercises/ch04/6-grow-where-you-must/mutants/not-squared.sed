# A distance is compared with a squared one.
# expect: square the distance to the border
s/gap \* gap > best/gap > best/
