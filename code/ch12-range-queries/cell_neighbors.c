//> Find neighbors in the cell array
// A block of cells around the query, then ring after ring, until the
// nearest that could lie outside is out of reach. The ways to cells are
// sums in the order of the coordinates, like distances, and never more
// than these.
#include "ch12-range-queries/cell_array.h"
#include "common/min_max.h"
#include <math.h>

//> Hold a search among the cells
struct search {
    const struct cell_array *cells;
    struct neighbor_query *query;
    int64_t home[MAX_DIMENSIONS]; // the cell of the query
    int64_t ring;                 // how far the block reaches
};
//<

//> Find the way to a slab
static double way_to(const struct search *search, int k, int64_t j)
{
    const struct cell_array *cells = search->cells;
    const double x = search->query->at[k];
    double way = 0;
    if (j < search->home[k])
        way = x - cells->max_up_to[k][j];
    else if (j > search->home[k])
        way = cells->min_from[k][j] - x;
    return way;
}
//<

//> Take the cells of a row
// Of a row that is on the ring, all cells; of others, the two ends.
static void take(const struct search *search, int64_t row,
                 int64_t first, int64_t last)
{
    const struct cell_array *cells = search->cells;
    const uint32_t *start = cells->start + row;
    search->query->steps += last - first + 1;
    take_neighbors(&cells->sorted, start[first], start[last + 1],
                   search->query);
}

static void take_row(const struct search *search, int64_t row, bool all)
{
    const int k = search->cells->sorted.points.d - 1;
    const int64_t count = search->cells->count[k];
    const int64_t first = search->home[k] - search->ring;
    const int64_t last = search->home[k] + search->ring;
    if (all) {
        take(search, row, MAX(first, 0), MIN(last, count - 1));
        return;
    }
    if (first >= 0)
        take(search, row, first, first);
    if (last < count)
        take(search, row, last, last);
}
//<

//> Walk over the rows of the ring
// The near ones first. sum2 is the way to the cells chosen so far, all
// says whether one of them is on the ring.
static void walk(const struct search *search, int k, int64_t row,
                 double sum2, bool all)
{
    const int64_t count = search->cells->count[k];
    row *= count;
    if (k == search->cells->sorted.points.d - 1) {
        take_row(search, row, all);
        return;
    }
    for (int64_t step = 0; step <= 2 * search->ring; step++) {
        const int64_t off = step % 2 ? -(step + 1) / 2 : step / 2;
        const int64_t j = search->home[k] + off;
        if (j < 0 || j >= count)
            continue;
        const double way = way_to(search, k, j);
        const double there2 = sum2 + way * way;
        const bool on_ring = step >= 2 * search->ring - 1;
        if (there2 <= search->query->reach2)
            walk(search, k + 1, row + j, there2, all || on_ring);
    }
}
//<

//> See what lies outside
// Whether some point that is within reach may be outside of the block.
static bool is_open(const struct search *search)
{
    const struct cell_array *cells = search->cells;
    double min_way = INFINITY;
    bool open = false;
    for (int k = 0; k < cells->sorted.points.d; k++) {
        const int64_t below = search->home[k] - search->ring - 1;
        const int64_t above = search->home[k] + search->ring + 1;
        if (below >= 0)
            min_way = MIN(way_to(search, k, below), min_way);
        if (above < cells->count[k])
            min_way = MIN(way_to(search, k, above), min_way);
        open |= below >= 0 || above < cells->count[k];
    }
    return open && min_way * min_way <= search->query->reach2;
}
//<

//> Choose the first block
// Around all that is within a distance; or of as many points as are
// wanted, if points are even.
static void choose_ring(struct search *search)
{
    const struct neighbor_query *query = search->query;
    const int d = search->cells->sorted.points.d;
    if (!query->nearest) {
        while (is_open(search))
            search->ring++;
        return;
    }
    while (pow(2 * search->ring + 1, d) * search->cells->per_cell <
               query->k &&
           is_open(search))
        search->ring++;
}

void cell_array_neighbors(const struct cell_array *cells,
                          struct neighbor_query *query)
{
    struct search search = {cells, query};
    for (int k = 0; k < cells->sorted.points.d; k++)
        search.home[k] = cell_along(cells, k, query->at[k]);
    choose_ring(&search);
    walk(&search, 0, 0, 0, true);
    while (is_open(&search)) {
        search.ring++;
        walk(&search, 0, 0, 0, false);
    }
}
//<
//<
