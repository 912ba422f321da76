# An attempt draws a number in any case.
# expect: must not have drawn a number
# why: It is the first line of acquire, copied.
s/return atomic_compare_exchange_strong_explicit(/return atomic_fetch_add(\&lock->next, 1) == now;/
/return atomic_fetch_add/,/memory_order_relaxed);/{
/return atomic_fetch_add/!d
}
