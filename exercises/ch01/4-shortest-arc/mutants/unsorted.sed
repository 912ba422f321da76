# The points are taken as they come.
# expect: sorted
# why: Their own examples were typed in ascending order.
s/qsort.*/(void)by_value;/
