# Does not clear the counts.
# expect: An index out of range
s/^        places\[b\] = 0;/        places[b] \&= 0xffffffff;/
