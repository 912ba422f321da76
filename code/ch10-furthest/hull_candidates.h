//> Declare the hull candidates
// Where the points are sorted by cell, nearly all of them can be left
// out without a look: a point that has others beyond it, and beyond the
// next cell, in all four diagonal directions is no corner. The rest are
// in two spans of every row, at the rim of the occupied cells, some
// eight sqrt(n c) of n evenly scattered points, c in a cell. This is
// what looking at the edge cells was meant to do.
#pragma once
#include "ch04-cell-sort/sorted.h"
#include "ch10-furthest/hull.h"

// The corners of the question's points, which are sorted; geometry and
// threads are the question's. The same as corners_find has, but
// for points that rounding leaves in doubt; and so is the memory.
struct corners corners_of_sorted(const struct question *question,
                                 const struct sorted *sorted,
                                 struct workspace *workspace);
//<
