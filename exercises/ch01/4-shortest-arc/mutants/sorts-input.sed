# The caller's array is sorted.
# expect: may only be read
# why: Sorting in place saves an allocation, and a cast silences the compiler that objected.
s/qsort(sorted,/qsort((double *)x,/
