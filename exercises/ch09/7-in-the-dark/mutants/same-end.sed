# Merges from the same end.
# expect: was lost
s/group\[k - 1 - i\]/group[i]/
