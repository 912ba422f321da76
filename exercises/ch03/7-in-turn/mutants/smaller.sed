# Waits while the sign shows a smaller number.
# expect: compare whether numbers are equal
# why: All numbers up to one's own have been served, one thinks, and forgets where numbers end.
/while (atomic_load/,/mine)/c\
    while (atomic_load(\&lock->serving) < mine)
