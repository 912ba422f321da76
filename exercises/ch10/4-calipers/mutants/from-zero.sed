# Begins at corner 0.
# expect: the search stands still
# why: Searches begin at 0.
s/k = 1 % n/k = 0/
