//> Measure in two geometries
// Squared distances in the two geometries. Wraparound is what others
// call periodic boundary conditions: along each axis, a separation d
// may count as d or as (box - d). The closest image, the minimum image
// of molecular dynamics, takes the smaller on each axis, the furthest
// image the larger. So the furthest is not the usual torus distance.
#pragma once
#include <math.h>

enum geometry { STANDARD = 1, WRAPAROUND = 2 }; // bits of a set

struct space {
    enum geometry geometry;
    double width, height; // of the box; wraparound only
};

//> Square a distance
static inline double distance2(double dx, double dy)
{
    return dx * dx + dy * dy;
}
//<

//> Measure to the closest image
static inline double closest2(struct space space, double dx, double dy)
{
    if (space.geometry == WRAPAROUND) {
        double ax = fabs(dx), bx = space.width - ax;
        double ay = fabs(dy), by = space.height - ay;
        return distance2(ax < bx ? ax : bx, ay < by ? ay : by);
    }
    return distance2(dx, dy);
}
//<

//> Measure to the furthest image
static inline double furthest2(struct space space, double dx, double dy)
{
    if (space.geometry == WRAPAROUND) {
        double ax = fabs(dx), bx = space.width - ax;
        double ay = fabs(dy), by = space.height - ay;
        return distance2(ax > bx ? ax : bx, ay > by ? ay : by);
    }
    return distance2(dx, dy);
}
//<
//<
