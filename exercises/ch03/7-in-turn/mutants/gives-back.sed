# An attempt draws a number and gives it back if it is not served.
# expect: in a single atomic step
# why: What was drawn in vain is put back, and nothing seems to have happened.
s/return atomic_compare_exchange_strong_explicit(/if (atomic_fetch_add(\&lock->next, 1) == now)\
        return true;\
    atomic_fetch_sub(\&lock->next, 1);\
    return false;/
/atomic_fetch_sub/,/memory_order_relaxed);/{
/atomic_fetch_sub/!d
}
