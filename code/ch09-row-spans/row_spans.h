//> Declare the search by row spans
// All nearest neighbors in three stages: partition (chapter 5), batch
// search, restore order. About 9 c + 22 distances a point, c points in
// a cell; threads share out the points. Some 60 bytes a point besides
// points and answers, all of it in the workspace.
#pragma once
#include "ch05-collisions/partition.h"
#include "ch09-row-spans/batch_search.h"

// Where this search is fastest on average.
#define POINTS_PER_SPAN_CELL 1.5

// The nearest neighbors of points that have been partitioned, with
// RESTORE, any number in a cell; threads and space are the question's.
// What it needs besides is taken from the workspace and given back.
void search_row_spans(const struct question *question,
                      const struct partition *partition,
                      struct workspace *workspace,
                      struct answers *answers);

// The search for the nearest alone, with results where the caller wants
// them, for drivers that search for more.
struct batch_search nearest_search(const struct scene *scene,
                                   const uint32_t *inverse,
                                   struct neighbor *results);

// The row of the table: all three stages.
search_function row_spans;
//<
