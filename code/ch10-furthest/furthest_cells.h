//> Declare the search from outside
// The furthest point by cells, whatever the points: rows of cells from
// the outside inward, and in a row its cells from the outside inward,
// as long as somebody in them can be further than the furthest so far.
// With wraparound the outside is where the point itself is. Empty cells
// cost nothing, empty rows neither. A few distances a point if the
// points are scattered evenly; at worst all of them.
#pragma once
#include "ch09-row-spans/carry.h"
#include "ch09-row-spans/manners.h"

// Where this search is fastest on average.
#define POINTS_PER_FAR_CELL 4.0

// Furthest only; threads and space are the question's. The points may
// have any number in a cell, where they stand in ascending order. Eight
// of them look TOGETHER where they stand together, or else each alone.
void search_furthest_cells(const struct question *question,
                           const struct carried *carried,
                           enum manner manner, struct answers *answers);

// Its counting twin: take the counts with counting_take.
void counting_search_furthest_cells(const struct question *question,
                                    const struct carried *carried,
                                    enum manner manner,
                                    struct answers *answers);

// The row of the table: sorts, and searches.
void furthest_cells(const struct question *question,
                    struct answers *answers);
//<
