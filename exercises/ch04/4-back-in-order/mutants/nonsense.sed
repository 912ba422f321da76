# The counts are added to what was there.
# expect: Was this ever set
# why: Their own test began with an array of zeros.
/memset/d
