# Finds the query itself.
# expect: the query itself
# why: Its distance is 0, and in the scalar search it was skipped by the loop.
s/(j != self)/1/
