//> Declare the sweep of a polygon
// A flat polygon with three or four corners moves, each corner along a
// straight line over the times 0 to 1. When does it first sweep over
// the origin? The differences between a node and the corners of a face,
// or between the ends of two edges, are such a polygon, and it sweeps
// over the origin when the two touch.
#pragma once
#include <stdbool.h>
#include <stdint.h>

//> Hold a polygon in motion
// Three corners: a triangle, with the parameters (0, 0), (1, 0) and
// (0, 1). Four: a parallelogram, (0, 0), (1, 0), (1, 1) and (0, 1).
struct sweep_corner {
    double at[2];       // parameters
    double place[2][3]; // at the beginning and at the end
};

struct sweep {
    int corners; // 3 or 4
    struct sweep_corner corner[4];
};
//<

//> Hold where the origin is met
struct sweep_hit {
    double time, at[2]; // the parameters of the point that meets it
};
//<

//> Hold a search for the origin
struct sweep_search {
    double near;      // closer is reported
    double fine;      // what moves or is wide no more is fine enough
    double allowance; // for the rounding of places and products
    struct sweep_hit hit;
    uint64_t pieces; // looked at
};

// Pieces are halved in the order of time, so that the first that is
// reported is the earliest. Returns whether one was: then the origin is
// not met before hit.time, and at that time the point of hit.at is
// within the tolerance of it. The tolerance is at least 2^-40 size.
bool sweep_find(const struct sweep *sweep, double size,
                double tolerance, struct sweep_search *search);
//<

//> Declare ways to miss the origin
// True only if the origin is certainly not met: if a plane through it,
// upright on n, has the whole motion on one side; if one of the three
// planes of coordinates has; if the plane of the polygon never comes
// over the origin. The allowance is a share of the size, see
// sweep_find.
bool sweep_is_beside(const struct sweep *sweep, const double n[3],
                     double allowance);
bool sweep_box_misses(const struct sweep *sweep, double allowance);
bool sweep_plane_misses(const struct sweep *sweep, double size);

// The largest coordinate, without its sign; and what rounding can spoil
// at such a size, which is at least MIN_EXACT of exact.h.
double sweep_size(const struct sweep *sweep);
double sweep_allowance(double size);
//<
//<
