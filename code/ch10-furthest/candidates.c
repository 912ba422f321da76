//> Sort candidates from left to right
// In buckets by x; what has the same x, by comparing. A few steps for
// each where the x are spread evenly, n log n at worst.
#include "ch10-furthest/candidates.h"
#include "ch10-furthest/sort_keys.h"
#include <stdlib.h>
#include <string.h>

//> Order two candidates
// From left to right, of the same x from below.
static int from_left(const void *one, const void *other)
{
    const struct candidate *a = one, *b = other;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    if (a->y != b->y)
        return a->y < b->y ? -1 : 1;
    return (a->point > b->point) - (a->point < b->point);
}
//<

//> Sort the candidates
// By x in buckets, then what has the same x. Of several in the same
// place the one of the lowest index stays.
static void sort_columns(struct candidate *candidate, uint32_t n)
{
    for (uint32_t begin = 0, end; begin < n; begin = end) {
        for (end = begin + 1; end < n; end++)
            if (candidate[end].x != candidate[begin].x)
                break;
        if (end - begin > 1)
            qsort(candidate + begin, end - begin, sizeof *candidate,
                  from_left);
    }
}

uint32_t sort_candidates(struct candidate *candidate, uint32_t n,
                         struct workspace *workspace)
{
    struct mark mark = workspace_mark(workspace);
    struct keyed *key = workspace_take(workspace, n, sizeof *key);
    struct keyed *sorted = workspace_take(workspace, n, sizeof *sorted);
    struct candidate *copy = workspace_take(workspace, n, sizeof *copy);
    for (uint32_t k = 0; k < n; k++)
        key[k] = (struct keyed){candidate[k].x, k};
    sort_keys(key, n, sorted, workspace);
    memcpy(copy, candidate, n * sizeof *copy);
    for (uint32_t k = 0; k < n; k++)
        candidate[k] = copy[sorted[k].number];
    sort_columns(candidate, n);
    uint32_t count = 1;
    for (uint32_t k = 1; k < n; k++)
        if (candidate[k].x != candidate[count - 1].x ||
            candidate[k].y != candidate[count - 1].y)
            candidate[count++] = candidate[k];
    workspace_release(workspace, mark);
    return count;
}
//<
//<
