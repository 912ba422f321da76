# A pair may replace only one of the two.
# expect: both
# why: In the plain loop an "else" is right, because a value cannot be both, so it survives when the loop begins to take pairs.
s/if (less(best.largest, large))/else if (less(best.largest, large))/
