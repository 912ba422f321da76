//> Declare the list of the k nearest
// What a query has found so far: first the k nearest, in order, then
// the candidates that were appended since. To append costs one
// comparison and no branch. Once there is no more room, or a bound is
// wanted, the list is put in order and cut to the k nearest.
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

//> Hold a neighbor that was found
struct found {
    double distance2; // from the query
    uint32_t index;
};
//<

//> Hold the list of the k nearest
struct k_nearest_list {
    uint32_t self;       // the query, which is not wanted
    uint32_t k;          // how many are wanted
    double reach2;       // nothing further is wanted, squared
    size_t count;        // found so far
    size_t ordered;      // the first of them, in order
    size_t room;         // of found
    struct found *found; // NULL: they are only counted
};
//<

// At most so many candidates are appended before there is another look
// at the room.
enum { MAX_APPENDED = 64 };

// With room for k of the nearest and for what is appended; released by
// k_nearest_list_free. For all within a distance, k is how many there
// are.
struct k_nearest_list k_nearest_list_make(size_t k);
void k_nearest_list_free(struct k_nearest_list *list);

// An empty list for another query.
void k_nearest_list_clear(struct k_nearest_list *list, uint32_t self,
                          double reach2);

// Puts the list in the order of the distances, and of the indices where
// these are equal, and cuts what is behind the k-th. If there are k,
// the k-th is the reach.
void keep_k_nearest(struct k_nearest_list *list);

// Puts all that was found in the same order. n log n steps.
void sort_found(struct found *found, size_t count);

//> Say which of two is nearer
static inline bool is_nearer(struct found a, struct found b)
{
    return a.distance2 < b.distance2 ||
           (a.distance2 == b.distance2 && a.index < b.index);
}
//<

//> Insert a neighbor
// Among the nearest, which are in order: those that are further are
// shifted by a place, and what would be behind the k-th is dropped.
// Says how many there are then.
static inline size_t insert_nearest(struct found *found, size_t count,
                                    size_t k, struct found one)
{
    size_t place = count;
    if (count < k)
        count++;
    else if (is_nearer(one, found[place - 1]))
        place--;
    else
        return count;
    for (; place > 0 && is_nearer(one, found[place - 1]); place--)
        found[place] = found[place - 1];
    found[place] = one;
    return count;
}
//<
//<
