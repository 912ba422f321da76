//> Seek from outside
// See furthest_cells.h. Nothing is lost to rounding: differences,
// squares and sums are rounded, but rounding keeps order, so that what
// is computed with the borders of a cell bounds what is computed with
// a point in it.
#pragma once
#include "ch10-furthest/viewer.h"

//> List the rows that have points
struct rows {
    uint32_t count, *row; // from below
    uint32_t *place;      // of a row in this list, if it is there
};

// Released with rows_free.
struct rows rows_find(const struct sorted *sorted);
void rows_free(struct rows *rows);
//<

// What a search looks at.
struct ground {
    const struct sorted *sorted;
    const struct rows *rows;
    struct space space;
};

// Looks at a cell in which nobody is further than bound2.
typedef void look_function(const enum geometry geometry,
                           struct space space,
                           const struct sorted *sorted, uint32_t cell,
                           double bound2, struct viewer *viewer);

//> Bound the separation from a cell
// Between x and whatever lies in cell k of the axis. With wraparound a
// separation d counts as the period less d, if that is more.
INLINED double far_in(const enum geometry geometry,
                      const struct axis *axis, uint32_t k, double x)
{
    double below = x - axis->border[k], above = axis->border[k + 1] - x;
    double far = most(below, above);
    if (geometry == STANDARD)
        return far;
    double apart = most(0, -least(below, above));
    return most(far, axis->period - apart);
}
//<

//> Bound the separation from all cells of an axis
INLINED double far_along(const enum geometry geometry,
                         const struct axis *axis, double x)
{
    double far =
        most(x - axis->border[0], axis->border[axis->count] - x);
    return geometry == STANDARD ? far : most(far, axis->period);
}
//<

//> Hold what is left of a ring
// Of the places begin .. end - 1, in a ring, those from first to last.
struct arc {
    uint32_t begin, end, first, last, left;
};

INLINED struct arc arc_from(uint32_t begin, uint32_t end,
                            uint32_t first)
{
    uint32_t last = first == begin ? end - 1 : first - 1;
    return (struct arc){begin, end, first, last, end - begin};
}

// So many places fewer, at the front or at the back.
INLINED void arc_shorten(struct arc *arc, bool front, uint32_t by)
{
    arc->left -= by;
    if (front) {
        arc->first += by;
        arc->first = arc->first < arc->end ? arc->first : arc->begin;
    } else {
        bool round = arc->last - arc->begin < by;
        arc->last = round ? arc->end - 1 : arc->last - by;
    }
}
//<

//> Find the further end
// How far things on the ring can be, whose ends lie in these two cells
// of the axis. If the ring still goes over the seam, where rounding may
// differ, its two sides have a say.
struct ends {
    bool front;       // the further
    double far, rest; // it alone; all that is left
};

INLINED struct ends find_ends(const enum geometry geometry,
                              const struct axis *axis, uint32_t one,
                              uint32_t other, double x, bool round,
                              double seam)
{
    double far = far_in(geometry, axis, one, x);
    double there = far_in(geometry, axis, other, x);
    double further = most(far, there);
    return (struct ends){far >= there, further,
                         geometry == WRAPAROUND && round
                             ? most(further, seam)
                             : further};
}
//<

//> Seek in a row
// Cells from both ends of what is left of the row, that first which may
// have somebody further. Up2 is how far the row is.
INLINED void seek_in_row(const enum geometry geometry,
                         look_function *look,
                         const struct ground *ground, uint32_t row,
                         double up2, struct viewer *viewer)
{
    const struct axis *axis = &ground->sorted->grid.x;
    const double *x = ground->sorted->points.x;
    const uint32_t base = row * axis->count;
    const uint32_t *start = ground->sorted->cells.start + base;
    const uint32_t begin = start[0], end = start[axis->count];
    uint32_t first = begin;
    double seam = 0;
    if (geometry == WRAPAROUND) {
        first = start[axis_cell(axis, viewer->x)];
        first = first < end ? first : begin;
        seam = most(far_in(geometry, axis, axis_cell(axis, x[begin]),
                           viewer->x),
                    far_in(geometry, axis, axis_cell(axis, x[end - 1]),
                           viewer->x));
    }
    struct arc arc = arc_from(begin, end, first);
    while (arc.left > 0) {
        uint32_t one = axis_cell(axis, x[arc.first]);
        uint32_t other = axis_cell(axis, x[arc.last]);
        struct ends ends =
            find_ends(geometry, axis, one, other, viewer->x,
                      arc.last < arc.first, seam);
        if (ends.rest * ends.rest + up2 < viewer->most2)
            break;
        uint32_t k = ends.front ? one : other;
        look(geometry, ground->space, ground->sorted, base + k,
             ends.far * ends.far + up2, viewer);
        arc_shorten(&arc, ends.front, start[k + 1] - start[k]);
    }
}
//<

//> Seek from the outermost row inwards
INLINED void seek_far(const enum geometry geometry, look_function *look,
                      const struct ground *ground,
                      struct viewer *viewer)
{
    const struct grid *grid = &ground->sorted->grid;
    const struct axis *axis = &grid->y;
    const struct rows *rows = ground->rows;
    const double far = far_along(geometry, &grid->x, viewer->x);
    uint32_t first = 0;
    double seam = 0;
    if (geometry == WRAPAROUND) {
        first = rows->place[axis_cell(axis, viewer->y)];
        seam = most(far_in(geometry, axis, rows->row[0], viewer->y),
                    far_in(geometry, axis, rows->row[rows->count - 1],
                           viewer->y));
    }
    struct arc arc = arc_from(0, rows->count, first);
    while (arc.left > 0) {
        uint32_t one = rows->row[arc.first];
        uint32_t other = rows->row[arc.last];
        struct ends ends =
            find_ends(geometry, axis, one, other, viewer->y,
                      arc.last < arc.first, seam);
        if (far * far + ends.rest * ends.rest < viewer->most2)
            break;
        seek_in_row(geometry, look, ground, ends.front ? one : other,
                    ends.far * ends.far, viewer);
        arc_shorten(&arc, ends.front, 1);
    }
}
//<
//<
