# An attempt looks, and then takes its place in the queue.
# expect: a pause in an attempt
# why: The lock was free when they looked, so acquire will not wait, they think.
s/return atomic_compare_exchange_strong_explicit(/if (lock->next != now)\
        return false;\
    acquire(lock);\
    return true;/
/lock->next != now/,/memory_order_relaxed);/{
/lock->next != now/!d
}
