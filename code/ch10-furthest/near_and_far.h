//> Declare the search near and far
// Both halves of the question: the nearest by row spans, the furthest
// by the corners' candidate grid, or with wraparound by batches, too.
// About 9 c + 23 distances a point, c points in a cell, if the points
// are spread evenly; with wraparound twice as many.
#pragma once
#include "ch05-collisions/partition.h"
#include "common/question.h"

// The row of the table. A half whose arrays in answers are NULL is
// left out.
search_function near_and_far;

// Points in a cell, on average.
#define PER_CELL_FOR_BOTH 2.0

// Its two steps: the points are sorted into cells, in the question's
// workspace; and searched there, the nearest too in the plane.
struct partition partition_for_both(const struct question *question,
                                    const struct answers *answers);
void search_near_and_far(const struct question *question,
                         const struct partition *partition,
                         struct answers *answers);
//<
