# Puts what is beyond the seam last.
# expect: not in ascending order
# why: They begin with home, and add what lies across afterward.
s/start\[x\[a\].first\]/start[x[nx - 1 - a].first]/;s/start\[x\[a\].last + 1\]/start[x[nx - 1 - a].last + 1]/
