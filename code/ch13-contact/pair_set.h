//> Declare the set of pairs
// Pairs of triangles that come and go: a table in which a pair is
// looked for from the place on that its hash says (Knuth 1963).
#pragma once
#include "ch13-contact/pairs.h"

//> Hold a set of pairs
struct pair_set {
    uint64_t *slot; // a pair each, or NO_PAIR
    int slot_bits; // 2^slot_bits slots, at least twice as many as pairs
    uint64_t count;
};
//<

// Empty, with some room; released with pair_set_free.
struct pair_set pair_set_make(void);
void pair_set_free(struct pair_set *set);

// Adds a pair, unless it is there; removes it, if it is there. i != j.
void pair_set_add(struct pair_set *set, uint32_t i, uint32_t j);
void pair_set_remove(struct pair_set *set, uint32_t i, uint32_t j);
void pair_set_clear(struct pair_set *set);

// Adds all pairs of the set to a list, in any order.
void pair_set_list(const struct pair_set *set, struct pair_list *list);
//<
