//> Declare the list of the nearest
// What a query has found so far: first what is in order, the nearest
// first, then what has come in since. To come in costs one comparison
// and no branch; once there is no more room, or a bound is wanted, the
// list is put in order and cut to the k nearest.
#pragma once
#include <stddef.h>
#include <stdint.h>

//> Hold the list of the nearest
struct found {
    double distance2;
    uint32_t index;
};

struct near_list {
    uint32_t self;       // the query, which is not wanted
    uint32_t k;          // how many are wanted
    double reach2;       // nothing further is wanted, squared
    size_t count;        // found so far
    size_t ordered;      // the first of them, in order
    size_t room;         // of found
    struct found *found; // NULL: they are only counted
};
//<

// So many come in without a look at the room.
enum { STRIP = 64 };

// With room for k of the nearest and for what comes in; released by
// near_list_free. For all within a distance, k is how many there are.
struct near_list near_list_make(size_t k);
void near_list_free(struct near_list *list);

// An empty list for another query.
void near_list_clear(struct near_list *list, uint32_t self,
                     double reach2);

// Puts the list in the order of the distances, and of the indices where
// these are equal, and cuts what is behind the k-th. If there are k,
// the k-th is the reach.
void near_list_settle(struct near_list *list);
//<
