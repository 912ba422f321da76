# Takes out only the one that is read.
# expect: either may have jumped
# why: The list so far is in order, so the new one is to blame.
s/^            room\[out++\] = order\[--kept\];//
