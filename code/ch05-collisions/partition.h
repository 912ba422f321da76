//> Declare the partition
// One sort of points into the cells of a grid, for one thread or many
// and always with the same result: first into buckets of cells, a few
// rows of the grid each, every thread with counts of its own for the
// buckets; then each bucket by itself, inside a cache and by one
// thread. A point travels as a record, with all it has, so that nothing
// is ever fetched from anywhere in memory: a radix partition, as Satish
// et al. (2010) do it. About 25 bytes a point beyond the result while
// it runs.
#pragma once
#include "ch04-cell-sort/sorted.h"
#include "common/workspace.h"
#include <stdbool.h>

//> Hold the result of a partition
// Permutation and inverse tell where the records were between the two
// steps: restore order (chapter 9) goes back the same way.
struct partition {
    struct sorted sorted;  // the points, sorted by cell
    uint32_t *permutation; // permutation[i]: the record of point i
    uint32_t *inverse;     // inverse[s]: the record that came to s
};
//<

// How many results, of 16 bytes a point, will want to come back: none,
// one, or two.
enum restore { NO_RESTORE, RESTORE, RESTORE_TWO };

// Sorts the points into the cells of the grid: start, point and points
// are what sorted_make gives, bit for bit. All arrays are taken from
// the workspace, where the caller keeps a mark; the grid's borders stay
// what they are. Permutation and inverse are NULL if not wanted.
// threads >= 1.
struct partition partition_points(const struct grid *grid,
                                  struct points points, int threads,
                                  enum restore restore,
                                  struct workspace *workspace);

// Fits a grid first, in the same workspace, with c points in a cell on
// average, c > 0, by the question's threads.
struct partition partition_make(const struct question *question,
                                double c, enum restore restore,
                                struct workspace *workspace);
//<
