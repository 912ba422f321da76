//> Search from outside
// The search of furthest_cells.h, a branch and bound, for each geometry
// and for eight lanes or one. Nothing is lost to rounding, which keeps
// order: what is computed with the borders of a cell bounds what is
// with a point in it. On a ring, where two ways are compared, bounds
// have a guard besides.
#pragma once
#include "ch10-furthest/far_batch.h"

//> Bound the separation from a cell
// Between x and whatever lies in cell k of the axis.
INLINED double max_separation(const enum geometry geometry,
                              const struct axis *axis, uint32_t k,
                              double x)
{
    double below = x - axis->border[k], above = axis->border[k + 1] - x;
    double far = MAX(below, above);
    if (geometry == WRAPAROUND) {
        //> Take the longer way around
        // A separation d counts as the period less d, if that is more.
        double apart = MAX(0, -MIN(below, above));
        far = MAX(far, axis->period - apart);
        //<
    }
    return far;
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

//> Hold what is not yet visited
// Of the rows, or of the points of a row: from first to last.
struct unvisited {
    uint32_t first, last, left; // left: how many
    //> Know the ring that they are part of
    // Of the places begin .. end - 1. With wraparound the visits begin
    // with the queries' own cells.
    uint32_t begin, end;
    uint32_t others; // that are not in the own cells
    //<
};
//<

//> Begin with all places of a ring
// All places begin .. end - 1, from first on, of which so many are in
// the own cells.
INLINED struct unvisited all_places(uint32_t begin, uint32_t end,
                                    uint32_t first, uint32_t own)
{
    first = first < end ? first : begin;
    uint32_t last = first == begin ? end - 1 : first - 1;
    uint32_t all = end - begin;
    return (struct unvisited){first, last, all, begin, end, all - own};
}
//<

//> Go on over the seam
// So many places on, or back; by is at most how many are left.
INLINED uint32_t place_ahead(const struct unvisited *rest, uint32_t by)
{
    uint32_t place = rest->first + by;
    return place < rest->end ? place : rest->begin;
}

INLINED uint32_t place_back(const struct unvisited *rest, uint32_t by)
{
    bool round = rest->last - rest->begin < by;
    return round ? rest->end - 1 : rest->last - by;
}
//<

//> Take an end off
INLINED void take_off(struct unvisited *rest, bool front, uint32_t by)
{
    rest->left -= by;
    if (front)
        rest->first = place_ahead(rest, by);
    else
        rest->last = place_back(rest, by);
}
//<

//> Bound what is along an axis
// Where on the axis the queries are, and how far all that is not yet
// visited can be on the other axis, squared.
struct axis_bounds {
    const struct axis *axis;
    const double *x, *other2;
};
//<

//> Hold the two ends
// In which cells of the axis they lie, and how far a point there can
// be. Filled in where it is: so many doubles are not to be copied.
struct ends {
    uint32_t one, other;
    bool front, done; // which is further; no lane can improve
    double front2[FAR_BATCH], back2[FAR_BATCH]; // how far, squared
};
//<

//> Find the further end
// What is between the ends is no further than one of them. The lane in
// the middle says which comes next.
INLINED void find_ends(const enum geometry geometry,
                       const uint32_t lanes,
                       const struct unvisited *rest,
                       const struct axis_bounds *bounds,
                       const struct far_batch *batch, struct ends *ends)
{
    const struct axis *axis = bounds->axis;
    const double *x = bounds->x;
    const bool own =
        geometry == WRAPAROUND && rest->left > rest->others;
    uint32_t some = 0;
#pragma omp simd reduction(| : some)
    for (uint32_t lane = 0; lane < lanes; lane++) {
        double one = max_separation(geometry, axis, ends->one, x[lane]);
        double other =
            max_separation(geometry, axis, ends->other, x[lane]);
        double far = MAX(one, other), guard = 1;
        if (geometry == WRAPAROUND) {
            //> Bound what is left of a ring
            // While own cells are left, any separation is possible.
            far = own ? MAX(far, axis->period) : far;
            guard = ROUNDING_GUARD;
            //<
        }
        double bound2 = (far * far + bounds->other2[lane]) * guard;
        some |= !(bound2 < batch->max2[lane]);
        ends->front2[lane] = one * one;
        ends->back2[lane] = other * other;
    }
    const uint32_t middle = lanes / 2;
    ends->done = !some;
    ends->front = own || ends->front2[middle] >= ends->back2[middle];
}

INLINED const double *far_end2(const struct ends *ends)
{
    return ends->front ? ends->front2 : ends->back2;
}
//<

//> Search a row
// Cells from both ends of the row, that first which may have a point
// further away. Up2 is how far the row is, squared.
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
    uint32_t first = start[0], own = 0;
    if (geometry == WRAPAROUND) {
        //> Cut the ring of a row open
        first = start[axis_cell(axis, batch->x[0])];
        own = start[axis_cell(axis, batch->x[lanes - 1]) + 1] - first;
        //<
    }
    struct unvisited rest =
        all_places(start[0], start[axis->count], first, own);
    while (rest.left > 0) {
        struct ends ends;
        ends.one = axis_cell(axis, x[rest.first]);
        ends.other = axis_cell(axis, x[rest.last]);
        find_ends(geometry, lanes, &rest, &bounds, batch, &ends);
        if (ends.done)
            break;
        uint32_t k = ends.front ? ends.one : ends.other;
        struct far_bounds far = {far_end2(&ends), up2};
        compare_cell(geometry, lanes, scene, base + k, &far, batch);
        take_off(&rest, ends.front, start[k + 1] - start[k]);
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
    double across2[FAR_BATCH];
    max_separations2(geometry, lanes, &grid->x, batch->x, across2);
    const struct axis_bounds bounds = {&grid->y, batch->y, across2};
    uint32_t first = 0, own = 0;
    if (geometry == WRAPAROUND) {
        //> Cut the ring of rows open
        // All queries are in one row.
        first = rows->place[axis_cell(&grid->y, batch->y[0])];
        own = 1;
        //<
    }
    struct unvisited rest = all_places(0, rows->count, first, own);
    while (rest.left > 0) {
        struct ends ends;
        ends.one = row[rest.first], ends.other = row[rest.last];
        find_ends(geometry, lanes, &rest, &bounds, batch, &ends);
        if (ends.done)
            break;
        search_row(geometry, lanes, scene,
                   ends.front ? ends.one : ends.other, far_end2(&ends),
                   batch);
        take_off(&rest, ends.front, 1);
    }
}
//<
//<
