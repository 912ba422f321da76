//> Declare the search from outside
// The furthest point by cells, whatever the points: rows of cells from
// the outside inward, and in a row its cells from the outside inward,
// as long as a point in them can be further than the furthest so far.
// With wraparound the outside is where the query itself is. Empty cells
// cost nothing, empty rows neither. A few distances a point if the
// points are scattered evenly; at worst all of them.
#pragma once
#include "ch05-collisions/partition.h"
#include "ch09-row-spans/batch_search.h"
#include "ch10-furthest/far_batch.h"

// Where this search is fastest on average.
#define POINTS_PER_FAR_CELL 4.0

// Furthest only; threads and space are the question's. The points were
// partitioned with RESTORE and may have any number in a cell. Eight
// queries that stand together are a batch, any other searches alone.
// What it needs besides is taken from the workspace and given back.
void search_furthest_cells(const struct question *question,
                           const struct partition *partition,
                           struct workspace *workspace,
                           struct answers *answers);

// The furthest of sorted point s alone.
void furthest_of_one(const struct far_scene *scene, uint32_t s,
                     struct neighbor *found, struct counts *counts);

// The row of the table: all three stages.
search_function furthest_cells;
//<
