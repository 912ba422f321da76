//> Cut a list
// A median by Hoare's FIND (1961), of a few coordinates, or of a copy
// of them all; then one pass over the list.
#include "ch11-crowds/cut.h"
#include "common/min_max.h"
#include "common/random.h"
#include <math.h>
#include <string.h>

//> Find the box of a list
struct box box_of(const struct point_record *record,
                  const uint32_t *list, uint32_t n)
{
    struct box box = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (uint32_t k = 0; k < n; k++) {
        const struct point_record *r = &record[list[k]];
        box.left = MIN(r->x, box.left);
        box.right = MAX(r->x, box.right);
        box.bottom = MIN(r->y, box.bottom);
        box.top = MAX(r->y, box.top);
    }
    return box;
}
//<

//> Find a median
// The value that stands at the middle once all are sorted. The pivot is
// one of them at random: n steps are expected, a few times over.
static double median(double *value, uint32_t n)
{
    struct random random = {n};
    uint32_t low = 0, high = n - 1;
    const uint32_t middle = n / 2;
    while (low < high) {
        const double pivot =
            value[low + random_bits(&random) % (high - low + 1)];
        uint32_t i = low, j = high;
        for (;;) {
            while (value[i] < pivot)
                i++;
            while (value[j] > pivot)
                j--;
            if (i >= j)
                break;
            double swap = value[i];
            value[i++] = value[j];
            value[j--] = swap;
        }
        // What is up to j is at most the pivot, from i on at least.
        if (i == j)
            j--, i++;
        if (middle <= j && j < high)
            high = j;
        else if (middle >= i)
            low = i;
        else
            return value[middle];
    }
    return value[middle];
}
//<

//> Choose where to cut
// At a value, or right above it, whichever is nearer to the middle and
// leaves something on either side. Says how many are less.
static uint32_t cut_near(const double *value, uint32_t n, double middle,
                         double *at)
{
    uint32_t below = 0, up_to = 0;
    double next = INFINITY;
    for (uint32_t k = 0; k < n; k++) {
        below += value[k] < middle;
        up_to += value[k] <= middle;
        next = MIN(next, value[k] > middle ? value[k] : INFINITY);
    }
    const bool here = up_to == n || n - below <= up_to;
    *at = here ? middle : next;
    return here ? below : up_to;
}

//> Try the median of a few
// It is nearly always near enough to that of all.
enum { FEW = 64 };

static double place_of_cut(double *value, uint32_t n)
{
    double few[FEW], at;
    struct random random = {n};
    const uint32_t count = MIN(n, FEW);
    for (uint32_t k = 0; k < count; k++)
        few[k] = value[random_bits(&random) % n];
    const uint32_t less = cut_near(value, n, median(few, count), &at);
    if (less < n / 8 || less > n - n / 8)
        cut_near(value, n, median(value, n), &at);
    return at;
}
//<
//<

//> Part the list
// Without a branch: what comes second is kept elsewhere until the end.
static inline double coordinate(const struct point_record *r, bool by_y)
{
    return by_y ? r->y : r->x;
}

static uint32_t part(const double *value, uint32_t *list, uint32_t n,
                     double at, uint32_t *room)
{
    uint32_t first = 0, second = 0;
    for (uint32_t k = 0; k < n; k++) {
        const uint32_t number = list[k];
        const bool less = value[k] < at;
        list[first] = number;
        room[second] = number;
        first += less;
        second += !less;
    }
    memcpy(list + first, room, second * sizeof *list);
    return first;
}
//<

//> Cut a list near its median
uint32_t cut_list(const struct point_record *record, uint32_t *list,
                  uint32_t n, const struct box *box,
                  struct cut_room room, struct cut *cut)
{
    double *value = room.values;
    cut->by_y = box->top - box->bottom > box->right - box->left ||
                box->left == box->right;
    for (uint32_t k = 0; k < n; k++)
        value[k] = coordinate(&record[list[k]], cut->by_y);
    cut->at = place_of_cut(value, n);
    for (uint32_t k = 0; k < n; k++)
        value[k] = coordinate(&record[list[k]], cut->by_y);
    return part(value, list, n, cut->at, room.numbers);
}
//<
//<
