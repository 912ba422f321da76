//> Declare the plane's index
// Points of the plane, put in the order of cells to be asked for
// neighbors: in one grid where they are spread evenly, and where they
// crowd in chapter 11's pieces. One grid is one piece, so that a query
// knows no difference.
#pragma once
#include "ch11-crowds/pieces.h"
#include <stdbool.h>

// Points in a cell of the one grid, on average.
enum { POINTS_PER_PLANE_CELL = 2 };

//> Hold the plane's index
struct plane_index {
    struct space space;
    int threads;
    bool is_even;           // one grid
    struct pieces pieces;   // of one grid: one
    uint32_t count, *piece; // the pieces in the order of their points
};
//<

// From the question's points, in its space, by its threads. All arrays
// are taken from the workspace, where the caller keeps a mark.
struct plane_index plane_index_make(const struct question *question,
                                    struct workspace *workspace);

// The number, among the pieces in order, of the one that has sorted
// point s.
uint32_t piece_of(const struct plane_index *index, uint32_t s);
//<
