# Does not clear the counts.
# expect: An index out of range
# why: The array is the caller's, and in their own test it was clear.
s/^        places\[b\] = 0;/        places[b] \&= 0xffffffff;/
