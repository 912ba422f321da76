//> Declare how pieces grow
// What all leaves of the splitter tree have in common while they become
// pieces, each by itself and by one thread.
#pragma once
#include "ch11-crowds/pieces.h"

//> Hold what the pieces grow from
struct growth {
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
// Where the borders of a piece begin, and its starts, if before it are
// so many points and pieces: behind three numbers for four points, and
// some more for each piece. A grid of n points has 2 n / 3 + 1/2 cells
// at most, and if all are in one row, columns and rows are one more;
// an axis has one border more than that, and is rounded up by 7 at
// most. That is 2 n / 3 + 17 1/2, and 3 n / 4 + 23 are there.
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
uint32_t grow_leaf(const struct growth *growth,
                   const struct leaf *leaf);
//<
