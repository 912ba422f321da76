//> Sweep along an axis
// A sort, and then for each box those that begin before it ends: in a
// cube of even boxes that is a slab, and n^(5/3) pairs in all.
#include "ch13-contact/axis_sweep.h"
#include "ch12-range-queries/order.h"
#include "common/allocate.h"
#include <omp.h>
#include <stdlib.h>
#include <string.h>

//> Hold a sweep along an axis
// The boxes in order have arrays of their own: the sweep then reads
// memory from one end to the other.
struct axis_sweep {
    bool kept;
    uint32_t n;
    int axis;        // along which we sweep
    uint32_t *order; // of the boxes
    struct boxes in_order;
    struct radix_record *room;
};
//<

//> Keep a sweep
void *begin_sweep(const struct broad_phase *phase)
{
    (void)phase;
    struct axis_sweep *sweep = allocate(1, sizeof *sweep);
    *sweep = (struct axis_sweep){0};
    return sweep;
}

void *begin_sweep_kept(const struct broad_phase *phase)
{
    struct axis_sweep *sweep = begin_sweep(phase);
    sweep->kept = true;
    return sweep;
}

void end_sweep(void *kept)
{
    struct axis_sweep *sweep = kept;
    boxes_free(&sweep->in_order);
    free(sweep->order);
    free(sweep->room);
    free(sweep);
}
//<

//> Choose the axis
// Along which low ends vary most.
static int axis_of(const struct boxes *boxes)
{
    int axis = 0;
    double max_variance = -1;
    for (int k = 0; k < 3; k++) {
        const double *x = boxes->low[k];
        double sum = 0, squares = 0;
        for (uint32_t t = 0; t < boxes->n; t++) {
            sum += x[t] - x[0];
            squares += (x[t] - x[0]) * (x[t] - x[0]);
        }
        const double variance = squares - sum * sum / boxes->n;
        if (variance > max_variance) {
            max_variance = variance;
            axis = k;
        }
    }
    return axis;
}
//<

//> Bring boxes into the order of the sweep
// The kept one stays with its axis, unless the boxes are others.
static void order_boxes(struct axis_sweep *sweep,
                        const struct boxes *boxes)
{
    const uint32_t n = boxes->n;
    const bool same = sweep->n == n;
    if (!same) {
        free(sweep->order);
        free(sweep->room);
        sweep->order = allocate(n, sizeof *sweep->order);
        sweep->room = allocate(2 * (size_t)n, sizeof *sweep->room);
        sweep->n = n;
        boxes_reserve(&sweep->in_order, n);
    }
    if (same && sweep->kept) {
        repair_order(boxes->low[sweep->axis], sweep->order, n,
                     sweep->room);
    } else {
        sweep->axis = axis_of(boxes);
        sort_order(boxes->low[sweep->axis], sweep->order, n,
                   sweep->room);
    }
    for (int k = 0; k < 3; k++)
        for (uint32_t r = 0; r < n; r++) {
            const uint32_t t = sweep->order[r];
            sweep->in_order.low[k][r] = boxes->low[k][t];
            sweep->in_order.high[k][r] = boxes->high[k][t];
        }
}
//<

//> Look from a box to the end of its interval
static void look_ahead(const struct broad_search *search,
                       const struct axis_sweep *sweep, uint32_t r,
                       struct pair_list *list)
{
    const struct boxes *b = &sweep->in_order;
    const int u = (sweep->axis + 1) % 3, v = (sweep->axis + 2) % 3;
    const double *low = b->low[sweep->axis];
    const double end = b->high[sweep->axis][r];
    const double low_u = b->low[u][r], high_u = b->high[u][r];
    const double low_v = b->low[v][r], high_v = b->high[v][r];
    uint32_t s = r + 1;
    for (; s < b->n && low[s] <= end; s++)
        if ((b->low[u][s] <= high_u) & (b->high[u][s] >= low_u) &
            (b->low[v][s] <= high_v) & (b->high[v][s] >= low_v))
            add_if_overlapping(search, list, sweep->order[r],
                               sweep->order[s]);
    list->tested += s - r - 1;
}
//<

//> Sweep over the boxes
void find_by_sweep(void *kept, const struct broad_search *search)
{
    struct axis_sweep *sweep = kept;
    const int threads = search->threads;
    order_boxes(sweep, search->boxes);
#pragma omp parallel for num_threads(threads) if (threads > 1) \
    schedule(dynamic, 256)
    for (uint32_t r = 0; r < sweep->n; r++)
        look_ahead(search, sweep, r,
                   &search->pairs->list[omp_get_thread_num()]);
}
//<
//<
