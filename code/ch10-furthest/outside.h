//> Search from outside
// The search of furthest_cells.h, for each geometry, for eight lanes or
// one. Nothing is lost to rounding, which keeps order: what is computed
// with the borders of a cell bounds what is with a point in it.
#pragma once
#include "ch10-furthest/far_batch.h"

//> Bound the separation from a cell
// Between x and whatever lies in cell k of the axis. With wraparound a
// separation d counts as the period less d, if that is more.
INLINED double max_separation(const enum geometry geometry,
                              const struct axis *axis, uint32_t k,
                              double x)
{
    double below = x - axis->border[k], above = axis->border[k + 1] - x;
    double far = MAX(below, above);
    if (geometry == STANDARD)
        return far;
    double apart = MAX(0, -MIN(below, above));
    return MAX(far, axis->period - apart);
}
//<

//> Bound the separation from all cells of an axis
// Squared, for every lane.
INLINED void max_separations2(const enum geometry geometry,
                              const uint32_t lanes,
                              const struct axis *axis, const double *x,
                              double *far2)
{
    const double low = axis->border[0];
    const double high = axis->border[axis->count];
    for (uint32_t lane = 0; lane < lanes; lane++) {
        double far = MAX(x[lane] - low, high - x[lane]);
        if (geometry == WRAPAROUND)
            far = MAX(far, axis->period);
        far2[lane] = far * far;
    }
}
//<

//> Hold what is left of a ring
// Of the places begin .. end - 1, in a ring, those from first to last.
// With wraparound it begins with the places of the queries' own cells.
struct arc {
    uint32_t begin, end, first, last, left;
    uint32_t others; // that are not in the own cells
};
//<

//> Shorten an arc
INLINED struct arc arc_from(uint32_t begin, uint32_t end,
                            uint32_t first, uint32_t own)
{
    first = first < end ? first : begin;
    uint32_t last = first == begin ? end - 1 : first - 1;
    uint32_t all = end - begin;
    return (struct arc){begin, end, first, last, all, all - own};
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

//> Bound what is along an axis
// What stays the same along an arc: where on the axis the queries are,
// and how far the arc's points are at most on the other one, squared.
struct axis_bounds {
    const struct axis *axis;
    const double *x, *other2;
};
//<

//> Hold the ends of an arc
// In which cells of the axis they lie, and how far a point there can
// be. Filled in where it is: so many doubles are not to be copied.
struct ends {
    uint32_t one, other;
    bool front, done; // which is further; no lane can improve
    double front2[FAR_BATCH], back2[FAR_BATCH]; // how far, squared
};
//<

//> Find the further end
// The bound for the whole arc is the larger of its two ends', over the
// seam, too: the bounds of its two sides are a column apart, and
// rounding is less. As long as the own cells are on it, they come
// first, and any distance is possible there. Else the lane in the
// middle says which end is further.
INLINED void find_ends(const enum geometry geometry,
                       const uint32_t lanes, const struct arc *arc,
                       const struct axis_bounds *bounds,
                       const struct far_batch *batch, struct ends *ends)
{
    const struct axis *axis = bounds->axis;
    const double *x = bounds->x;
    const bool own = arc->left > arc->others;
    uint32_t some = 0;
#pragma omp simd reduction(| : some)
    for (uint32_t lane = 0; lane < lanes; lane++) {
        //> Bound the arc in a lane
        double far = max_separation(geometry, axis, ends->one, x[lane]);
        double there =
            max_separation(geometry, axis, ends->other, x[lane]);
        double rest = MAX(far, there);
        if (geometry == WRAPAROUND && own)
            rest = MAX(rest, axis->period);
        some |=
            !(rest * rest + bounds->other2[lane] < batch->max2[lane]);
        ends->front2[lane] = far * far;
        ends->back2[lane] = there * there;
        //<
    }
    const uint32_t middle = lanes / 2;
    ends->done = !some;
    ends->front = own || ends->front2[middle] >= ends->back2[middle];
}
//<

//> Choose the bound of the further end
INLINED const double *far_end2(const struct ends *ends)
{
    return ends->front ? ends->front2 : ends->back2;
}
//<

//> Lay out a row
INLINED struct arc lay_out_row(const enum geometry geometry,
                               const uint32_t lanes,
                               const uint32_t *start,
                               const struct axis_bounds *bounds)
{
    const struct axis *axis = bounds->axis;
    const uint32_t begin = start[0], end = start[axis->count];
    if (geometry == STANDARD)
        return arc_from(begin, end, begin, 0);
    uint32_t first = start[axis_cell(axis, bounds->x[0])];
    uint32_t next = start[axis_cell(axis, bounds->x[lanes - 1]) + 1];
    return arc_from(begin, end, first, next - first);
}
//<

//> Search a row
// Cells from both ends of what is left of the row, that first which may
// have a point further away. Up2 is how far the row is.
INLINED void search_row(const enum geometry geometry,
                        const uint32_t lanes,
                        const struct far_scene *scene, uint32_t row,
                        const double *up2, struct far_batch *batch)
{
    const struct sorted *sorted = scene->sorted;
    const struct axis *axis = &sorted->grid.x;
    const double *x = sorted->points.x;
    const uint32_t base = row * axis->count;
    const uint32_t *start = sorted->cells.start + base;
    const struct axis_bounds bounds = {axis, batch->x, up2};
    struct arc arc = lay_out_row(geometry, lanes, start, &bounds);
    while (arc.left > 0) {
        struct ends ends;
        ends.one = axis_cell(axis, x[arc.first]);
        ends.other = axis_cell(axis, x[arc.last]);
        find_ends(geometry, lanes, &arc, &bounds, batch, &ends);
        if (ends.done)
            break;
        uint32_t k = ends.front ? ends.one : ends.other;
        struct far_bounds far = {far_end2(&ends), up2};
        compare_cell(geometry, lanes, scene, base + k, &far, batch);
        arc_shorten(&arc, ends.front, start[k + 1] - start[k]);
    }
}
//<

//> Search from the outermost row inward
INLINED void search_from_outside(const enum geometry geometry,
                                 const uint32_t lanes,
                                 const struct far_scene *scene,
                                 struct far_batch *batch)
{
    const struct grid *grid = &scene->sorted->grid;
    const struct rows *rows = scene->rows;
    const uint32_t *row = rows->row;
    double far2[FAR_BATCH];
    max_separations2(geometry, lanes, &grid->x, batch->x, far2);
    const struct axis_bounds bounds = {&grid->y, batch->y, far2};
    //> Lay out all rows
    // With wraparound the ring, cut open before the first of the
    // queries. They are in one row, and in a row anywhere, but in
    // order.
    struct arc arc = arc_from(0, rows->count, 0, 0);
    if (geometry == WRAPAROUND) {
        const uint32_t own = axis_cell(&grid->y, batch->y[0]);
        arc = arc_from(0, rows->count, rows->place[own], 1);
    }
    //<
    while (arc.left > 0) {
        struct ends ends;
        ends.one = row[arc.first], ends.other = row[arc.last];
        find_ends(geometry, lanes, &arc, &bounds, batch, &ends);
        if (ends.done)
            break;
        search_row(geometry, lanes, scene,
                   ends.front ? ends.one : ends.other, far_end2(&ends),
                   batch);
        arc_shorten(&arc, ends.front, 1);
    }
}
//<
//<
