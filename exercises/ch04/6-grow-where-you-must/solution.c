// The nearest neighbor from a block that grows on one side at a time,
// on the one whose border is nearest, until that one is too far away.
#include "exercise.h"
#include <math.h>

//- solution
struct block {
    uint32_t left, right, bottom, top; // its outermost cells
};
enum side { LEFT, RIGHT, BELOW, ABOVE, SIDES };

// How far away its border is; INFINITY at the edge of the grid.
static double away(const struct grid *grid, struct block b,
                   enum side side, double x, double y)
{
    if (side == LEFT && b.left > 0)
        return x - grid->column_border[b.left];
    if (side == RIGHT && b.right + 1 < grid->columns)
        return grid->column_border[b.right + 1] - x;
    if (side == BELOW && b.bottom > 0)
        return y - grid->row_border[b.bottom];
    if (side == ABOVE && b.top + 1 < grid->rows)
        return grid->row_border[b.top + 1] - y;
    return INFINITY;
}

// Moves one side of the block and returns the strip that is new.
static struct block extend(struct block *b, enum side side)
{
    struct block strip = *b;
    if (side == LEFT)
        strip.left = strip.right = --b->left;
    if (side == RIGHT)
        strip.left = strip.right = ++b->right;
    if (side == BELOW)
        strip.bottom = strip.top = --b->bottom;
    if (side == ABOVE)
        strip.bottom = strip.top = ++b->top;
    return strip;
}

static struct found better(struct found a, struct found b)
{
    if (a.nearest2 != b.nearest2)
        return a.nearest2 < b.nearest2 ? a : b;
    return a.nearest < b.nearest ? a : b;
}

//- starter
//- end
struct found grow(const struct grid *grid, uint32_t column,
                  uint32_t row, double x, double y)
{
    //- solution
    struct block block = {column, column, row, row};
    struct found best = look(column, row);
    for (;;) {
        enum side nearest = LEFT;
        double gap = away(grid, block, LEFT, x, y);
        for (enum side side = RIGHT; side < SIDES; side++)
            if (away(grid, block, side, x, y) < gap) {
                nearest = side;
                gap = away(grid, block, side, x, y);
            }
        if (gap == INFINITY || gap * gap > best.nearest2)
            return best;
        struct block strip = extend(&block, nearest);
        for (uint32_t r = strip.bottom; r <= strip.top; r++)
            for (uint32_t c = strip.left; c <= strip.right; c++)
                best = better(best, look(c, r));
    }
    //- starter
    // // Your turn: this looks around the point, but never further.
    // struct found best = look(column, row);
    // for (uint32_t r = row; r < grid->rows && r <= row + 1; r++)
    //     for (uint32_t c = column;
    //          c < grid->columns && c <= column + 1; c++) {
    //         struct found here = look(c, r);
    //         if (here.nearest2 < best.nearest2)
    //             best = here;
    //     }
    // return best;
    //- end
}
