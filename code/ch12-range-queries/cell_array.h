//> Declare the cell array
// Cells of equal width in d dimensions and the points sorted by cell,
// the last coordinate running fastest: so the cells of a row are next
// to each other, and so are their points.
#pragma once
#include "ch12-range-queries/neighbors.h"
#include "ch12-range-queries/scan.h"

//> Hold the cell array
struct cell_array {
    struct sorted_points sorted;
    struct range range;             // of all points
    uint32_t count[MAX_DIMENSIONS]; // cells along each coordinate
    double scale[MAX_DIMENSIONS];   // cells for each unit of length
    uint32_t *start; // where each cell begins, and behind all, the end
    bool in_order;   // in a cell: by the last coordinate
    double per_cell;
    // Along each coordinate: the greatest number in slabs 0 to j, and
    // the least in slab j and all that follow.
    double *max_up_to[MAX_DIMENSIONS], *min_from[MAX_DIMENSIONS];
};
//<

// The points per cell that the table of structures asks for.
enum { POINTS_PER_CELL = 3 };

// Cells of per_cell points on average; in_order if binary searches
// shall be used inside of cells. The points are copied. Released with
// cell_array_free.
struct cell_array cell_array_make(const struct point_set *points,
                                  double per_cell, bool in_order);
void cell_array_free(struct cell_array *cells);
size_t cell_array_bytes(const struct cell_array *cells);

//> Find the cell of a number
// The cell of a number along coordinate k; never falls where the
// number grows. Numbers beyond the range are in the first or last.
static inline uint32_t cell_along(const struct cell_array *cells, int k,
                                  double x)
{
    const double cell = (x - cells->range.low[k]) * cells->scale[k];
    const double last = cells->count[k] - 1;
    return cell >= last ? (uint32_t)last
           : cell > 0   ? (uint32_t)cell
                        : 0;
}
//<

void cell_array_query(const struct cell_array *cells,
                      const struct range *range, struct report *report);
void cell_array_neighbors(const struct cell_array *cells,
                          struct neighbor_query *query);
//<
