//> Follow the ends of boxes
// Insertion along each axis: an end that moves past another one is a
// swap, and there are as many as neighbors have changed their order.
// A step costs one look at each end and a look into the set of pairs
// for each swap; with too many swaps, a sort and a sweep.
#include "ch13-contact/sweep_and_prune.h"
#include "ch12-range-queries/radix_sort.h"
#include "ch13-contact/axis_sweep.h"
#include "ch13-contact/pair_set.h"
#include "common/allocate.h"
#include <stdlib.h>

//> Hold the ends of boxes
struct box_end {
    double x;
    uint32_t name; // 2 box, or 2 box + 1 for its high end
};

struct sweep_and_prune {
    uint32_t n;
    const uint32_t *group;  // when it was built
    struct box_end *end[3]; // 2 n along each axis, in order
    struct pair_set meeting;
    struct radix_record *room;
    void *sweep; // for the first step
};
//<

//> Keep ends from step to step
void *begin_sweep_and_prune(const struct broad_phase *phase)
{
    struct sweep_and_prune *kept = allocate(1, sizeof *kept);
    *kept = (struct sweep_and_prune){.meeting = pair_set_make(),
                                     .sweep = begin_sweep(phase)};
    return kept;
}

static void free_ends(struct sweep_and_prune *kept)
{
    for (int k = 0; k < 3; k++)
        free(kept->end[k]);
    free(kept->room);
}

void end_sweep_and_prune(void *kept)
{
    struct sweep_and_prune *k = kept;
    free_ends(k);
    pair_set_free(&k->meeting);
    end_sweep(k->sweep);
    free(k);
}
//<

//> Sort the ends along an axis
// Of equal ones the low ends come first: boxes that touch meet. A radix
// sort keeps the order of equal ones.
static double end_of_box(const struct boxes *boxes, int k,
                         uint32_t name)
{
    const double *x = name % 2 ? boxes->high[k] : boxes->low[k];
    return x[name / 2];
}

static void sort_ends(struct sweep_and_prune *kept,
                      const struct boxes *boxes, int k)
{
    const uint32_t n = kept->n;
    struct radix_record *record = kept->room;
    for (uint32_t r = 0; r < 2 * n; r++) {
        const uint32_t name = r < n ? 2 * r : 2 * (r - n) + 1;
        record[r] = (struct radix_record){
            radix_key(end_of_box(boxes, k, name)), name};
    }
    radix_sort(record, 2 * n, 64, record + 2 * (size_t)n);
    for (uint32_t r = 0; r < 2 * n; r++) {
        const uint32_t name = record[r].point;
        kept->end[k][r] =
            (struct box_end){end_of_box(boxes, k, name), name};
    }
}
//<

//> Build from scratch
static void build(struct sweep_and_prune *kept,
                  const struct broad_search *search)
{
    const struct boxes *boxes = search->boxes;
    if (kept->n != boxes->n) {
        const size_t ends = 2 * (size_t)boxes->n;
        free_ends(kept);
        for (int k = 0; k < 3; k++)
            kept->end[k] = allocate(ends, sizeof *kept->end[k]);
        kept->room = allocate(2 * ends, sizeof *kept->room);
        kept->n = boxes->n;
    }
    kept->group = search->group;
    for (int k = 0; k < 3; k++)
        sort_ends(kept, boxes, k);
    find_by_sweep(kept->sweep, search);
    pair_set_clear(&kept->meeting);
    for (int t = 0; t < search->pairs->threads; t++) {
        struct pair_list *list = &search->pairs->list[t];
        for (uint64_t p = 0; p < list->count; p++)
            pair_set_add(&kept->meeting, list->pair[p].one,
                         list->pair[p].other);
        list->count = 0;
    }
}
//<

//> See what a swap means
// The end that moves down passes another one. A low end that passes a
// high end: the two overlap along this axis from now on. A high end
// that passes a low end: no longer.
static void pass(struct sweep_and_prune *kept,
                 const struct broad_search *search, uint32_t down,
                 uint32_t up)
{
    const uint32_t i = down / 2, j = up / 2;
    if (down % 2 == up % 2 || i == j ||
        is_same_group(search->group, i, j))
        return;
    if (down % 2)
        pair_set_remove(&kept->meeting, i, j);
    else if (box_meets(search->boxes, i, search->boxes, j))
        pair_set_add(&kept->meeting, i, j);
}
//<

//> Repair the order of the ends
// False if that takes too many swaps.
enum { MAX_SWAPS = 32 }; // for each end, along all axes

static bool is_behind(struct box_end a, struct box_end b)
{
    return a.x > b.x || (a.x == b.x && a.name % 2 > b.name % 2);
}

static bool repair(struct sweep_and_prune *kept,
                   const struct broad_search *search, int k,
                   uint64_t *swaps)
{
    const uint32_t ends = 2 * kept->n;
    const uint64_t max_swaps = MAX_SWAPS * (uint64_t)ends;
    struct box_end *end = kept->end[k];
    for (uint32_t r = 0; r < ends; r++)
        end[r].x = end_of_box(search->boxes, k, end[r].name);
    for (uint32_t r = 1; r < ends && *swaps <= max_swaps; r++) {
        const struct box_end moved = end[r];
        uint32_t place = r;
        for (; place > 0 && is_behind(end[place - 1], moved); place--) {
            pass(kept, search, moved.name, end[place - 1].name);
            end[place] = end[place - 1];
        }
        end[place] = moved;
        *swaps += r - place;
    }
    return *swaps <= max_swaps;
}
//<

//> Keep to the boxes
void find_by_sweep_and_prune(void *kept,
                             const struct broad_search *search)
{
    struct sweep_and_prune *s = kept;
    uint64_t swaps = 0;
    bool repaired =
        s->n == search->boxes->n && s->group == search->group;
    for (int k = 0; k < 3 && repaired; k++)
        repaired = repair(s, search, k, &swaps);
    if (!repaired)
        build(s, search);
    pair_set_list(&s->meeting, &search->pairs->list[0]);
    search->pairs->list[0].tested += swaps;
}
//<
//<
