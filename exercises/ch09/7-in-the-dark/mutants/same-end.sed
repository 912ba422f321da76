# Merges from the same end.
# expect: was lost
# why: Pairs of equal rank look natural; the eight smallest are then not among the lesser ones.
s/group\[k - 1 - i\]/group[i]/
