//> Declare the cell ids
// Every point's cell, by arithmetic alone: the one part of the sort
// that vectors and threads have no trouble with.
#pragma once
#include "ch04-cell-sort/grid.h"

// Writes the cells of the points begin .. end - 1 to cell_id[begin] and
// so on.
void find_cell_ids(const struct grid *grid, struct points points,
                   uint32_t begin, uint32_t end, uint32_t *cell_id);
//<
