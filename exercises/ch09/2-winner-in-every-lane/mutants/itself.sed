# Finds the point that asks.
# expect: the point that asks
# why: Its distance is 0, and in the scalar search it was skipped by the loop.
s/(j != self)/1/
