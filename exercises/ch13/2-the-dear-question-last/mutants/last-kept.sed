# Compares with the last pair that was kept.
# expect: it may not have been kept
# why: It stands ready at the end of the list.
s/^        last = next;//
s/pair\[kept++\] = next;/pair[kept++] = last = next;/
