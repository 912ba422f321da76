//> Separate two moving triangles
// Corners move along straight lines, so along any direction they are
// between where they begin and where they end. A direction costs twelve
// dot products, all twelve directions some 720 operations.
#include "ch13-contact/separating_axis.h"
#include "ch13-contact/vectors.h"
#include "common/min_max.h"

//> Hold the corners of both
// Of the first and of the second triangle, three at the beginning and
// three at the end, seen from one of them: so the numbers are small.
struct corners {
    double at[2][6][3];
    double apart; // how far is surely far enough
};
//<

//> See both from one corner
static struct corners corners_of(const struct moving_triangle *p,
                                 const struct moving_triangle *q,
                                 double tolerance)
{
    struct corners corners;
    const double *origin = p->corner[0].begin;
    double size = 0;
    for (int side = 0; side < 2; side++)
        for (int c = 0; c < 6; c++) {
            const struct moving *m =
                &(side == 0 ? p : q)->corner[c % 3];
            subtract(c < 3 ? m->begin : m->end, origin,
                     corners.at[side][c]);
            const double here = largest(corners.at[side][c]);
            size = MAX(size, here);
        }
    corners.apart = tolerance + 0x1p-26 * size;
    return corners;
}
//<

//> Compare along a direction
// The gap must be more than the tolerance, and more than all rounding:
// errors are below 2^-48 of the largest coordinate, apart has 2^-26.
static bool separates(const struct corners *corners,
                      const double axis[3])
{
    double low[2], high[2];
    for (int side = 0; side < 2; side++) {
        low[side] = high[side] = dot(corners->at[side][0], axis);
        for (int c = 1; c < 6; c++) {
            const double place = dot(corners->at[side][c], axis);
            low[side] = MIN(low[side], place);
            high[side] = MAX(high[side], place);
        }
    }
    const double gap = MAX(low[1] - high[0], low[0] - high[1]);
    const double reach = corners->apart * 2 * largest(axis);
    return gap > reach;
}
//<

//> Try the directions
static void edge_of(const struct corners *corners, int side, int e,
                    double edge[3])
{
    subtract(corners->at[side][(e + 1) % 3], corners->at[side][e],
             edge);
}

static bool normal_separates(const struct corners *corners, int side)
{
    double a[3], b[3], axis[3];
    edge_of(corners, side, 0, a);
    edge_of(corners, side, 1, b);
    cross(a, b, axis);
    return separates(corners, axis);
}

static bool middles_separate(const struct corners *corners)
{
    double axis[3];
    for (int k = 0; k < 3; k++) {
        axis[k] = 0;
        for (int c = 0; c < 6; c++)
            axis[k] += corners->at[1][c][k] - corners->at[0][c][k];
    }
    return separates(corners, axis);
}
//<

//> Try twelve directions
bool has_separating_axis(const struct moving_triangle *p,
                         const struct moving_triangle *q,
                         double tolerance)
{
    const struct corners corners = corners_of(p, q, tolerance);
    if (normal_separates(&corners, 0) ||
        normal_separates(&corners, 1) || middles_separate(&corners))
        return true;
    for (int e = 0; e < 9; e++) {
        double a[3], b[3], axis[3];
        edge_of(&corners, 0, e / 3, a);
        edge_of(&corners, 1, e % 3, b);
        cross(a, b, axis);
        if (separates(&corners, axis))
            return true;
    }
    return false;
}
//<
//<
