# The points are taken as they come.
# expect: sorted
s/qsort.*/(void)by_value;/
