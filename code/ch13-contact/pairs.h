//> Declare the pairs
// Pairs of triangles whose boxes meet: found by several threads, in any
// order, and then brought into one. All room is kept from step to step.
#pragma once
#include "ch13-contact/boxes.h"
#include <stddef.h>

//> Hold pairs
struct pair {
    uint32_t one, other; // one < other
};

// What one thread has found so far.
struct pair_list {
    struct pair *pair;
    uint64_t count, room;
    uint64_t tested; // pairs of boxes that were looked at
};

struct pairs {
    struct pair *pair; // sorted by one, then by other
    uint64_t count, room;
    uint64_t *start;    // pairs of t: start[t] to start[t + 1] - 1
    uint32_t triangles; // that there is room for
    uint64_t tested;
    struct pair_list *list; // of each thread
    int threads;
};
//<

// None found yet, by so many threads. {0} holds nothing; released with
// pairs_free.
void pairs_begin(struct pairs *pairs, int threads);
void pairs_free(struct pairs *pairs);

// Puts what the threads found among n triangles in order: no pair comes
// twice in their lists.
void pairs_gather(struct pairs *pairs, uint32_t n);

// Twice the room for a list.
void pair_list_grow(struct pair_list *list);

//> Add a pair
static inline void pair_add(struct pair_list *list, uint32_t i,
                            uint32_t j)
{
    if (list->count == list->room)
        pair_list_grow(list);
    list->pair[list->count++] =
        i < j ? (struct pair){i, j} : (struct pair){j, i};
}
//<
//<
