# Does not sort the steps by their angles.
# expect: not in the order of their angles
# why: The steps come out of the loops in some order, and it looks like one.
/qsort/d
