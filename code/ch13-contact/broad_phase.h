//> Declare the table of broad phases
// Whatever is in the table is in contact --list, and is run by every
// test of this chapter.
#pragma once
#include "ch13-contact/pairs.h"
#include "common/points.h"

//> Hold a broad search
// Which boxes meet? Pairs of the same group (scene.h) are left out, or
// none if group is NULL.
struct broad_search {
    const struct boxes *boxes;
    const uint32_t *group;
    struct pairs *pairs;
    int threads;
};
//<

//> Describe a broad phase
// What it keeps from step to step belongs to the caller, who gives it
// to end.
struct broad_phase {
    const char *name;  // as in contact -a NAME
    const char *about; // one line for contact --list
    const char *inner; // the name of what it works with: a structure of
                       // chapter 12, or a broad phase for clusters;
                       // NULL if nothing
    void *(*begin)(const struct broad_phase *phase);
    // At least two boxes. Each pair comes once into some thread's list.
    void (*find)(void *kept, const struct broad_search *search);
    void (*end)(void *kept);
};
//<

extern const struct broad_phase broad_phases[];
extern const int broad_phase_count;

// NULL if there is no such broad phase.
const struct broad_phase *find_broad_phase(const char *name);

// All pairs of boxes that meet, sorted, in search->pairs.
void find_pairs(const struct broad_phase *phase, void *kept,
                const struct broad_search *search);

//> Take a pair if its boxes meet
static inline bool is_same_group(const uint32_t *group, uint32_t i,
                                 uint32_t j)
{
    return group && group[i] == group[j] && group[i] != NO_INDEX;
}

static inline void add_if_overlapping(const struct broad_search *search,
                                      struct pair_list *list,
                                      uint32_t i, uint32_t j)
{
    if (box_meets(search->boxes, i, search->boxes, j) &&
        !is_same_group(search->group, i, j))
        pair_add(list, i, j);
}
//<
//<
