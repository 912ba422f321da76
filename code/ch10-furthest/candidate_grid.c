//> Cut the box into cells of candidates
// A quadtree of squares, each with the corners that can be the furthest
// for a point in it, until one corner is left. Coordinates are measured
// from the box's lower left, so that they are as exact as the box is
// large. Whether a is further than b is decided by |q - a|^2 - |q -
// b|^2, which changes evenly with q: in a square it is least in one of
// the four corners of the square. Squared distances, computed here or
// there, err by less than 2^-50 of that of the box's diagonal, so 2^-46
// is a safe margin.
#include "ch10-furthest/candidate_grid.h"
#include "ch04-cell-sort/grid.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

//> Hold a candidate grid in the making
// What is known while the grid is made.
struct builder {
    struct points points; // the corners, from the lower left
    double width, height; // of the box
    double margin;        // in squared distances
    size_t enough;        // entries in all lists
    struct candidate_grid *grid;
    struct workspace *workspace;
};

// Cells left .. left + side - 1 in rows bottom and so on.
struct square {
    uint32_t left, bottom, side;
};
//<

//> Keep what can be the furthest in a square
// Of the corners from[0 .. count-1], all but those that are nearer, to
// every point in the square, than the one furthest from its middle.
// The square is taken a little larger than it is, for rounding.
static uint32_t keep_far(const struct builder *builder,
                         struct square square, const uint32_t *from,
                         uint32_t count, uint32_t *to)
{
    const struct points p = builder->points;
    const double width = builder->width / builder->grid->side;
    const double height = builder->height / builder->grid->side;
    const double x = (square.left + 0.5 * square.side) * width;
    const double y = (square.bottom + 0.5 * square.side) * height;
    const double right = 0.5 * square.side * width * (1 + 0x1p-20);
    const double up = 0.5 * square.side * height * (1 + 0x1p-20);
    double max2 = -1;
    uint32_t far = 0, kept = 0;
    //> Find the corner furthest from the middle
    for (uint32_t k = 0; k < count; k++) {
        double d2 = distance2(p.x[from[k]] - x, p.y[from[k]] - y);
        if (d2 > max2)
            max2 = d2, far = from[k];
    }
    //<
    //> Cross out what is nearer everywhere
    for (uint32_t k = 0; k < count; k++) {
        uint32_t b = from[k];
        double d2 = distance2(p.x[b] - x, p.y[b] - y);
        double change = 2 * (fabs(p.x[far] - p.x[b]) * right +
                             fabs(p.y[far] - p.y[b]) * up);
        if (!(max2 - d2 > change + builder->margin))
            to[kept++] = b;
    }
    //<
    return kept;
}
//<

//> Give a square its list
// All its cells share it.
static void give_list(const struct builder *builder,
                      struct square square, const uint32_t *list,
                      uint32_t count)
{
    struct candidate_grid *grid = builder->grid;
    uint32_t entry = list[0];
    if (count > 1) {
        entry = grid->corners + (uint32_t)grid->length;
        //> Add a list to the lists
        size_t needed = grid->length + count + 1;
        if (needed > grid->room) {
            uint32_t *old = grid->list;
            grid->room = 2 * needed;
            grid->list = workspace_take(builder->workspace, grid->room,
                                        sizeof *old);
            if (old)
                memcpy(grid->list, old, grid->length * sizeof *old);
        }
        grid->list[grid->length] = count;
        memcpy(grid->list + grid->length + 1, list,
               count * sizeof *list);
        grid->length = needed;
        //<
    }
    for (uint32_t row = 0; row < square.side; row++) {
        uint32_t *cell = grid->cell +
                         (size_t)(square.bottom + row) * grid->side +
                         square.left;
        for (uint32_t column = 0; column < square.side; column++)
            cell[column] = entry;
    }
}
//<

//> Divide a square
// Into four, until one corner is left, or it is a cell, or the lists
// get too long. to has room for all lists that this one comes from.
static void divide(const struct builder *builder, struct square square,
                   const uint32_t *from, uint32_t count, uint32_t *to)
{
    uint32_t kept = keep_far(builder, square, from, count, to);
    if (kept == 1 || square.side == 1 ||
        builder->grid->length > builder->enough) {
        give_list(builder, square, to, kept);
        return;
    }
    uint32_t half = square.side / 2;
    for (int quarter = 0; quarter < 4; quarter++) {
        struct square part = {square.left + quarter % 2 * half,
                              square.bottom + quarter / 2 * half, half};
        divide(builder, part, to, kept, to + kept);
    }
}
//<

//> Choose how many cells of candidates
// Eight to thirty-two points to a cell. But on a circle, the worst
// case, each of side^2 cells lists some corners / side, or half as many
// again. So side * corners must not be more than MAX_LISTED.
enum { POINTS_PER_CANDIDATE_CELL = 8, MAX_LISTED = 1 << 24 };

static uint32_t side_for(uint32_t n, uint32_t corners)
{
    double most = (double)MAX_LISTED / corners;
    uint32_t side = 1;
    while (4.0 * side * side <= (double)n / POINTS_PER_CANDIDATE_CELL &&
           2.0 * side <= most)
        side *= 2;
    return side;
}
//<

//> Scale a length to cells
static double cells_per(uint32_t side, double length)
{
    double per = side / length;
    return isfinite(per) ? per : 0; // 0 * 0 is in the first
}
//<

//> Begin with the whole box
static void make_lists(struct builder *builder, uint32_t side,
                       uint32_t h)
{
    uint32_t levels = 2;
    for (uint32_t k = side; k > 1; k /= 2)
        levels++;
    uint32_t *from =
        workspace_take(builder->workspace, h, sizeof *from);
    uint32_t *room = workspace_take(builder->workspace,
                                    (size_t)levels * h, sizeof *room);
    for (uint32_t k = 0; k < h; k++)
        from[k] = k;
    // Some side * h corners on a circle, and a count in every cell:
    // four times as much.
    builder->enough = (size_t)4 * side * (h + side);
    divide(builder, (struct square){0, 0, side}, from, h, room);
}
//<

//> Make the candidate grid
struct candidate_grid candidate_grid_make(const struct corners *corners,
                                          uint32_t n,
                                          struct workspace *workspace)
{
    const struct points p = corners->points;
    const struct extent x = extent_of(p.x, p.n, 1);
    const struct extent y = extent_of(p.y, p.n, 1);
    const double width = x.high - x.low, height = y.high - y.low;
    const double diagonal2 = distance2(width, height);
    const bool fits = diagonal2 > MIN_D2 && diagonal2 < MAX_D2;
    const uint32_t side = fits ? side_for(n, p.n) : 1;
    struct candidate_grid grid = {.side = side, .corners = p.n};
    //> Lay the grid over the box
    if (fits) { // else any x * 0 is 0, and in the only one
        grid.left = x.low, grid.across = cells_per(side, width);
        grid.bottom = y.low, grid.up = cells_per(side, height);
    }
    grid.cell = workspace_take(workspace, (size_t)side * side,
                               sizeof *grid.cell);
    //<
    //> Measure from the lower left
    const struct points low = corners_take(p.n, workspace).points;
    for (uint32_t k = 0; k < p.n; k++) {
        low.x[k] = p.x[k] - x.low;
        low.y[k] = p.y[k] - y.low;
    }
    //<
    struct builder builder = {.points = low,
                              .width = width,
                              .height = height,
                              .margin =
                                  fits ? diagonal2 * 0x1p-46 : INFINITY,
                              .grid = &grid,
                              .workspace = workspace};
    // If all squared distances vanish, one corner is enough.
    make_lists(&builder, side, diagonal2 > 0 ? p.n : 1);
    return grid;
}
//<
//<
