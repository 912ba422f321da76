//> Declare two searches that err
// The furthest neighbors in the standard geometry, looked for where the
// coursework looks: in all cells along the border of the grid, or in
// those that the corner trick leaves over. Right as long as no corner
// cell is empty (edge cells), or no cell at all (one corner); else the
// answer may be wrong, and nothing tells.
#pragma once
#include "ch04-cell-sort/sorted.h"
#include <stdbool.h>

// In any grid, for the furthest only; a query that finds no other point
// gets NO_INDEX, at -1; of a tie the lowest index. Threads are the
// question's.
void search_edge_cells(const struct question *question,
                       const struct sorted *sorted,
                       struct answers *answers);
void search_one_corner(const struct question *question,
                       const struct sorted *sorted,
                       struct answers *answers);

//> Hold a circle around a query
// Through the nearest corner of the cell in the furthest corner of the
// grid.
struct circle {
    double x, y, radius2;
};
//<

struct circle circle_around(const struct grid *grid, double x,
                            double y);

//> Find the part of a cell outside a circle
// How far from x a coordinate in cell k can be.
static inline double far_in_cell(const struct axis *axis, uint32_t k,
                                 double x)
{
    return fmax(x - axis->border[k], axis->border[k + 1] - x);
}

static inline bool partly_outside(const struct grid *grid,
                                  const struct circle *circle,
                                  uint32_t column, uint32_t row)
{
    return distance2(far_in_cell(&grid->x, column, circle->x),
                     far_in_cell(&grid->y, row, circle->y)) >
           circle->radius2;
}
//<
//<
