# A point that ties goes before those that were there.
# expect: the lower index comes first
# why: "<=" and "<" are thought to be a matter of taste as long as the distances come out right.
s/d2 >= distances2\[k - 1\]/d2 > distances2[k - 1]/
s/distances2\[place - 1\] > d2/distances2[place - 1] >= d2/
