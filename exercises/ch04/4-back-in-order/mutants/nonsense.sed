# The counts are added to what was there.
# expect: Was this ever set
/memset/d
