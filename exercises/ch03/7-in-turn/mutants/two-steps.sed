# The number is read and moved on in two atomic steps, without a pause.
# expect: in a single atomic step
# why: Each step is atomic, and what lies between them is too short to be seen.
/atomic_fetch_add_explicit/c\
        lock->next;\
    lock->next = mine + 1;
