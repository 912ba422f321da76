# Overwrites one before it compares the other.
# expect: kept more than once
# why: a = least(a, b); b = most(a, b): it looks like an exchange.
/const struct key \*greater = most/d
s/\*b = greater;/*b = most(*a, *b);/
