# The caller's array is sorted.
# expect: may only be read
s/qsort(sorted,/qsort((double *)x,/
