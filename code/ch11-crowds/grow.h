//> Declare how pieces grow
// Each leaf of the splitter tree becomes pieces by itself, by one
// thread: fitted to a grid, counted, and cut again where it crowds.
// m log m steps at worst for m points.
#pragma once
#include "ch11-crowds/pieces.h"

//> Hold what the pieces grow from
struct leaf_context {
    struct pieces *pieces;
    struct point_record *record; // the points, sent to the leaves
    uint32_t *start;             // room for the cells of all pieces
    double *border;              // and for their borders
};
//<

//> Set when to cut
// A leaf is cut again if its points share their cells with more than so
// many on average, themselves included, and if it has more points than
// is worth while to cut.
static const double CROWDED = 8;
enum { FEWEST_TO_CUT = 96 };
//<

//> Limit the pieces of a leaf
// Of n points: it is cut no more when it has as many parts as that.
enum { POINTS_PER_SLOT = 32 };

static inline uint32_t piece_slots(uint32_t n)
{
    return n / POINTS_PER_SLOT + 2;
}
//<

//> Make room for grids
// Where the borders and the starts of a piece begin, behind those of
// so many points and pieces. Reserved are three numbers for every four
// points, and a few for every piece. That is enough: a grid of n points
// has 2 n / 3 + 1/2 cells at most. If all are in one row, columns and
// rows are one more together, each axis has one border more than cells,
// and its length is rounded up by 7 at most: 2 n / 3 + 17 1/2 in all,
// and at least 3 n / 4 + 23 are reserved.
enum { SPARE_BORDERS = 24, SPARE_STARTS = 4 };

static inline size_t border_begin(size_t points, size_t pieces)
{
    return points - points / 4 + SPARE_BORDERS * pieces;
}

static inline size_t start_begin(size_t points, size_t pieces)
{
    return points - points / 4 + SPARE_STARTS * pieces;
}
//<

//> Hold a leaf
// The records begin .. end - 1, the region around them, the first node
// and the first piece that it may use.
struct leaf {
    uint32_t begin, end;
    struct box region;
    uint32_t node, piece;
};
//<

// Turns a leaf into pieces and nodes, and says how many pieces.
uint32_t grow_leaf(const struct leaf_context *context,
                   const struct leaf *leaf);
//<
