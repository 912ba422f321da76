//> Keep a set of pairs
// To add, to remove or to look takes constant time on average. No mark
// is left where a pair is removed: those behind it move up.
#include "ch13-contact/pair_set.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include <stdlib.h>
#include <string.h>

#define NO_PAIR UINT64_MAX

//> Make an empty set
static uint64_t *empty_slots(int bits)
{
    const size_t bytes = sizeof(uint64_t) << bits;
    return memset(allocate(bytes, 1), 0xff, bytes);
}

struct pair_set pair_set_make(void)
{
    enum { FEW_BITS = 8 };
    return (struct pair_set){empty_slots(FEW_BITS), FEW_BITS};
}

void pair_set_free(struct pair_set *set)
{
    free(set->slot);
    *set = (struct pair_set){0};
}

void pair_set_clear(struct pair_set *set)
{
    memset(set->slot, 0xff, sizeof *set->slot << set->slot_bits);
    set->count = 0;
}
//<

//> Look for a pair
// The slot that has it, or the empty one where it would be.
static uint64_t home_of(const struct pair_set *set, uint64_t pair)
{
    return (pair * 0x9e3779b97f4a7c15) >> (64 - set->slot_bits);
}

static uint64_t slot_of(const struct pair_set *set, uint64_t pair)
{
    const uint64_t last = ((uint64_t)1 << set->slot_bits) - 1;
    uint64_t s = home_of(set, pair);
    while (set->slot[s] != pair && set->slot[s] != NO_PAIR)
        s = (s + 1) & last;
    return s;
}

static uint64_t key_of_pair(uint32_t i, uint32_t j)
{
    return (uint64_t)MIN(i, j) << 32 | MAX(i, j);
}
//<

//> Add a pair to the set
static void double_slots(struct pair_set *set)
{
    const uint64_t *old = set->slot;
    const uint64_t count = (uint64_t)1 << set->slot_bits;
    set->slot = empty_slots(++set->slot_bits);
    for (uint64_t s = 0; s < count; s++)
        if (old[s] != NO_PAIR)
            set->slot[slot_of(set, old[s])] = old[s];
    free((void *)old);
}

void pair_set_add(struct pair_set *set, uint32_t i, uint32_t j)
{
    if (set->count >> (set->slot_bits - 1))
        double_slots(set);
    const uint64_t pair = key_of_pair(i, j);
    const uint64_t s = slot_of(set, pair);
    set->count += set->slot[s] == NO_PAIR;
    set->slot[s] = pair;
}
//<

//> Remove a pair from the set
// A pair behind the gap moves into it if it would have been looked for
// there: if its home is not between the gap and where it is.
void pair_set_remove(struct pair_set *set, uint32_t i, uint32_t j)
{
    const uint64_t last = ((uint64_t)1 << set->slot_bits) - 1;
    uint64_t gap = slot_of(set, key_of_pair(i, j));
    if (set->slot[gap] == NO_PAIR)
        return;
    set->count--;
    for (uint64_t s = (gap + 1) & last; set->slot[s] != NO_PAIR;
         s = (s + 1) & last) {
        const uint64_t home = home_of(set, set->slot[s]);
        if (((s - home) & last) >= ((s - gap) & last)) {
            set->slot[gap] = set->slot[s];
            gap = s;
        }
    }
    set->slot[gap] = NO_PAIR;
}
//<

//> List the set
void pair_set_list(const struct pair_set *set, struct pair_list *list)
{
    const uint64_t count = (uint64_t)1 << set->slot_bits;
    for (uint64_t s = 0; s < count; s++)
        if (set->slot[s] != NO_PAIR)
            pair_add(list, (uint32_t)(set->slot[s] >> 32),
                     (uint32_t)set->slot[s]);
}
//<
//<
