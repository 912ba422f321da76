//> Declare a query of the plane
// One point's neighbors, among the points of an index: a block of cells
// around it that has enough points gives a reach; then what else is
// within reach, down the tree of boxes, row by row. Each cell is looked
// at once at most.
#pragma once
#include "ch12-range-queries/k_nearest_list.h"
#include "ch12-range-queries/plane_index.h"

//> Hold a query of the plane
struct plane_query {
    const struct plane_index *index;
    const struct piece *piece; // that the query is in
    double x, y;
    struct k_nearest_list *list;
    struct cell_block { // of the piece, looked at already
        uint32_t left, right, bottom, top;
    } block;
    bool has_block;
    uint64_t compared, steps; // distances; boxes and rows
};
//<

// Fills the list with the k nearest, or if its reach is less than
// INFINITY with all within reach, no more than k. Where it has no room
// they are only counted. The list is left unordered.
void plane_query_run(struct plane_query *query);
//<
