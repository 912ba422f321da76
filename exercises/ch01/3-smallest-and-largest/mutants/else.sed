# A pair may replace only one of the two.
# expect: both
s/if (less(best.largest, large))/else if (less(best.largest, large))/
