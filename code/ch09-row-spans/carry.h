//> Declare the sort that carries the points
// Chapter 5's sort by bands of cells, in which a point travels with its
// coordinates: once to its band, once to its place. So nobody has to
// fetch it from where it was, anywhere in memory. About 24 bytes a
// point beyond the result while it runs.
#pragma once
#include "ch04-cell-sort/sorted.h"

//> Remember how the points came
struct carried {
    struct sorted sorted;
    uint32_t *sent; // sent[i]: in which parcel point i went
    uint32_t *came; // came[s]: in which that at place s came
};
//<

// The points of the question in a grid with c of them in a cell on
// average, c > 0, by all its threads: sorted as by any sorted_make, bit
// for bit. Released with carried_free.
struct carried carry_points(const struct question *question, double c);
void carried_free(struct carried *carried);
//<
