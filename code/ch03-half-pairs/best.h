//> Keep a best that threads share
// A candidate is a key and an index; the smaller key is the better
// one, and of equal keys the lower index, so that the outcome does not
// depend on which thread comes first. The rule: outside a guard a key
// is only read, and atomically; an index is not even read. A key is
// never NAN. Double checks: Schmidt and Harrison, 1997; the repair by
// atomic reads: Boehm and Adve, 2008.
#pragma once
#include "common/inlined.h"
#include <math.h>
#include <stdatomic.h>
#include <stdint.h>

//> Keep a key and its index together
struct best {
    _Atomic double key; // never NAN, except while it is taken away
    uint32_t index;
};

// The squared distance to the nearest, and minus the squared distance
// to the furthest: arrays of n.
struct bests {
    struct best *near, *far;
};
//<

// All keys at their worst, without an index: two arrays of n. Ends the
// program if memory is short. Released by bests_free.
struct bests bests_begin(uint32_t n);
void bests_free(struct bests *bests);

//> Guard everything
INLINED void offer_locked(struct best *best, double key, uint32_t index)
{
#pragma omp critical(best)
    {
        double held =
            atomic_load_explicit(&best->key, memory_order_relaxed);
        if (key < held || (key == held && index < best->index)) {
            atomic_store_explicit(&best->key, key,
                                  memory_order_relaxed);
            best->index = index;
        }
    }
}
//<

//> Look, then guard, then look again
INLINED void offer_critical(struct best *best, double key,
                            uint32_t index)
{
    double held =
        atomic_load_explicit(&best->key, memory_order_relaxed);
    if (key <= held)
        offer_locked(best, key, index);
}
//<

//> Take the key away while its index changes
// NAN in the key's place means that a thread is at work there. Nothing
// is greater, less or equal to NAN, so no thread turns away: all wait.
INLINED void offer_atomic(struct best *best, double key, uint32_t index)
{
    double held =
        atomic_load_explicit(&best->key, memory_order_relaxed);
    while (!(key > held)) {
        if (isnan(held)) {
            held =
                atomic_load_explicit(&best->key, memory_order_relaxed);
        } else if (atomic_compare_exchange_weak_explicit(
                       &best->key, &held, NAN, memory_order_acquire,
                       memory_order_relaxed)) {
            //> Change the index and give the key back
            if (key < held || index < best->index) {
                best->index = index;
                held = key;
            }
            atomic_store_explicit(&best->key, held,
                                  memory_order_release);
            return;
            //<
        }
    }
}
//<
//<
