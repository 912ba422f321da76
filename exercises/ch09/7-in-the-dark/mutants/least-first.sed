# Overwrites one before it compares the other.
# expect: kept more than once
/const struct key \*greater = most/d
s/\*b = greater;/*b = most(*a, *b);/
