// A lock that serves in turn (a ticket lock): each thread draws a
// number, and waits until this number is served.
#include "exercise.h"

void acquire(struct lock *lock)
{
    //- solution
    uint32_t mine =
        atomic_fetch_add_explicit(&lock->next, 1, memory_order_relaxed);
    while (atomic_load_explicit(&lock->serving, memory_order_acquire) !=
           mine)
        pause_before_next_look();
    //- starter
    // // Your turn. So far the door is open to all.
    // lock->next++;
    //- end
}

void release(struct lock *lock)
{
    //- solution
    // Only the thread that has the lock writes this number.
    uint32_t mine =
        atomic_load_explicit(&lock->serving, memory_order_relaxed);
    atomic_store_explicit(&lock->serving, mine + 1,
                          memory_order_release);
    //- starter
    // lock->serving++;
    //- end
}

bool try_acquire(struct lock *lock)
{
    //- solution
    uint32_t now =
        atomic_load_explicit(&lock->serving, memory_order_acquire);
    return atomic_compare_exchange_strong_explicit(
        &lock->next, &now, now + 1, memory_order_relaxed,
        memory_order_relaxed);
    //- starter
    // acquire(lock);
    // return true;
    //- end
}
