//> Declare the table of broad phases
// Whatever is in the table is in contact --list, and is run by every
// test of this chapter.
#pragma once
#include "ch13-contact/pairs.h"

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
struct broad {
    const char *name;   // as in contact -a NAME
    const char *about;  // one line for contact --list
    const char *detail; // name of a structure of chapter 12, or of the
                        // broad phase for clusters; or NULL
    void *(*begin)(const struct broad *broad);
    // At least two boxes. Each pair comes once into some thread's list.
    void (*find)(void *kept, const struct broad_search *search);
    void (*end)(void *kept);
};
//<

extern const struct broad broads[];
extern const int broad_count;

// NULL if there is no such broad phase.
const struct broad *find_broad(const char *name);

// All pairs of boxes that meet, sorted, in search->pairs.
void find_pairs(const struct broad *broad, void *kept,
                const struct broad_search *search);

//> Take a pair if its boxes meet
static inline void consider(const struct broad_search *search,
                            struct pair_list *list, uint32_t i,
                            uint32_t j)
{
    const uint32_t *group = search->group;
    if (boxes_meet(search->boxes, i, j) &&
        (!group || group[i] != group[j] || group[i] == UINT32_MAX))
        pair_add(list, i, j);
}
//<
//<
