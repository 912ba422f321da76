// The search that a reader writes first, and that errs: the nearest of
// nine cells, with no test of whether that is near enough. A query that
// finds no candidate is given NO_INDEX, at INFINITY.
#pragma once
#include "ch04-cell-sort/sorted.h"

void search_nine_cells(const struct question *question,
                       const struct sorted *sorted,
                       struct answers *answers);
