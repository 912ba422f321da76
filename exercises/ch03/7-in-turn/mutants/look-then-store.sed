# The number is read and moved on in two steps.
# expect: in a single atomic step
# why: Both steps are atomic, so it seems that both together are.
/atomic_fetch_add_explicit/c\
        lock->next;\
    pause_before_next_look();\
    lock->next = mine + 1;
