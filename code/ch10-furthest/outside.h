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
// Squared, for all who look.
INLINED void far_along(const enum geometry geometry,
                       const uint32_t lanes, const struct axis *axis,
                       const double *x, double *far2)
{
    const double low = axis->border[0];
    const double high = axis->border[axis->count];
    for (uint32_t lane = 0; lane < lanes; lane++) {
        double far = most(x[lane] - low, high - x[lane]);
        if (geometry == WRAPAROUND)
            far = most(far, axis->period);
        far2[lane] = far * far;
    }
}
//<

//> Hold what is left of a ring
// Of the places begin .. end - 1, in a ring, those from first to last.
// With wraparound it begins with home, where those who look are.
struct arc {
    uint32_t begin, end, first, last, left;
    uint32_t others; // who are not at home
};

INLINED struct arc arc_from(uint32_t begin, uint32_t end,
                            uint32_t first, uint32_t home)
{
    first = first < end ? first : begin;
    uint32_t last = first == begin ? end - 1 : first - 1;
    uint32_t all = end - begin;
    return (struct arc){begin, end, first, last, all, all - home};
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

//> Hold an outlook
// What stays the same along an arc: where on the axis those who look
// are, how far it is at most on the other one, and how far the two
// sides of the seam are.
struct outlook {
    const struct axis *axis;
    const double *x, *beside2;
    double seam[ABREAST];
};

INLINED void see_seam(const enum geometry geometry,
                      const uint32_t lanes, uint32_t low, uint32_t high,
                      struct outlook *outlook)
{
    const struct axis *axis = outlook->axis;
    for (uint32_t lane = 0; lane < lanes; lane++)
        outlook->seam[lane] =
            most(far_in(geometry, axis, low, outlook->x[lane]),
                 far_in(geometry, axis, high, outlook->x[lane]));
}
//<

//> Find the further end
// How far things on the arc can be, whose ends lie in these two cells
// of the axis. If it still goes over the seam, where rounding may
// differ, its two sides have a say. As long as home is on it, home
// comes first, and anything can be there. Else whoever stands in the
// middle says which end is further. Filled in where they are: so many
// doubles are not to be copied.
struct ends {
    bool front, done; // which is further; nobody gains
    double front2[ABREAST], back2[ABREAST]; // how far, squared
};

INLINED void find_ends(const enum geometry geometry,
                       const uint32_t lanes, uint32_t one,
                       uint32_t other, const struct arc *arc,
                       const struct outlook *outlook,
                       const struct viewers *viewers, struct ends *ends)
{
    const struct axis *axis = outlook->axis;
    const bool round = arc->last < arc->first;
    const bool home = arc->left > arc->others;
    uint32_t some = 0;
#pragma omp simd reduction(| : some)
    for (uint32_t lane = 0; lane < lanes; lane++) {
        double far = far_in(geometry, axis, one, outlook->x[lane]);
        double there = far_in(geometry, axis, other, outlook->x[lane]);
        double rest = most(far, there);
        if (geometry == WRAPAROUND && round)
            rest = most(rest, outlook->seam[lane]);
        if (geometry == WRAPAROUND && home)
            rest = most(rest, axis->period);
        some |= !(rest * rest + outlook->beside2[lane] <
                  viewers->most2[lane]);
        ends->front2[lane] = far * far;
        ends->back2[lane] = there * there;
    }
    const uint32_t middle = lanes / 2;
    ends->done = !some;
    ends->front = home || ends->front2[middle] >= ends->back2[middle];
}

INLINED const double *far_end2(const struct ends *ends)
{
    return ends->front ? ends->front2 : ends->back2;
}
//<

//> Lay out all rows, or one
// With wraparound the ring, cut open before the first of those who
// look. They are in one row, and in a row anywhere, but in order.
INLINED struct arc lay_out_rows(const enum geometry geometry,
                                const uint32_t lanes,
                                const struct rows *rows,
                                struct outlook *outlook)
{
    if (geometry == STANDARD)
        return arc_from(0, rows->count, 0, 0);
    see_seam(geometry, lanes, rows->row[0], rows->row[rows->count - 1],
             outlook);
    uint32_t own = axis_cell(outlook->axis, outlook->x[0]);
    return arc_from(0, rows->count, rows->place[own], 1);
}

INLINED struct arc lay_out_row(const enum geometry geometry,
                               const uint32_t lanes,
                               const struct points points,
                               const uint32_t *start,
                               struct outlook *outlook)
{
    const struct axis *axis = outlook->axis;
    const uint32_t begin = start[0], end = start[axis->count];
    if (geometry == STANDARD)
        return arc_from(begin, end, begin, 0);
    see_seam(geometry, lanes, axis_cell(axis, points.x[begin]),
             axis_cell(axis, points.x[end - 1]), outlook);
    uint32_t first = start[axis_cell(axis, outlook->x[0])];
    uint32_t next = start[axis_cell(axis, outlook->x[lanes - 1]) + 1];
    return arc_from(begin, end, first, next - first);
}
//<

//> Seek in a row
// Cells from both ends of what is left of the row, that first which may
// have somebody further. Up2 is how far the row is.
INLINED void seek_in_row(const enum geometry geometry,
                         const uint32_t lanes,
                         const struct ground *ground, uint32_t row,
                         const double *up2, struct viewers *viewers)
{
    const struct sorted *sorted = ground->sorted;
    const struct axis *axis = &sorted->grid.x;
    const double *x = sorted->points.x;
    const uint32_t base = row * axis->count;
    const uint32_t *start = sorted->cells.start + base;
    struct outlook outlook = {axis, viewers->x, up2, {0}};
    struct arc arc =
        lay_out_row(geometry, lanes, sorted->points, start, &outlook);
    while (arc.left > 0) {
        uint32_t one = axis_cell(axis, x[arc.first]);
        uint32_t other = axis_cell(axis, x[arc.last]);
        struct ends ends;
        find_ends(geometry, lanes, one, other, &arc, &outlook, viewers,
                  &ends);
        if (ends.done)
            break;
        uint32_t k = ends.front ? one : other;
        look_at(geometry, lanes, ground->space, sorted, base + k,
                far_end2(&ends), up2, viewers);
        arc_shorten(&arc, ends.front, start[k + 1] - start[k]);
    }
}
//<

//> Seek from the outermost row inward
INLINED void seek_far(const enum geometry geometry,
                      const uint32_t lanes, const struct ground *ground,
                      struct viewers *viewers)
{
    const struct grid *grid = &ground->sorted->grid;
    const uint32_t *row = ground->rows->row;
    double far2[ABREAST];
    far_along(geometry, lanes, &grid->x, viewers->x, far2);
    struct outlook outlook = {&grid->y, viewers->y, far2, {0}};
    struct arc arc =
        lay_out_rows(geometry, lanes, ground->rows, &outlook);
    while (arc.left > 0) {
        uint32_t one = row[arc.first], other = row[arc.last];
        struct ends ends;
        find_ends(geometry, lanes, one, other, &arc, &outlook, viewers,
                  &ends);
        if (ends.done)
            break;
        seek_in_row(geometry, lanes, ground, ends.front ? one : other,
                    far_end2(&ends), viewers);
        arc_shorten(&arc, ends.front, 1);
    }
}
//<
//<
