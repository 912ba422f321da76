# An attempt waits.
# expect: does not wait
# why: To try is read as to try until it works.
s/return atomic_compare_exchange_strong_explicit(/acquire(lock); return (void)now, true;/
/acquire(lock); return/,/memory_order_relaxed);/{
/acquire(lock); return/!d
}
