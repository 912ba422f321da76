//> Declare the search for the origin
// A flat polygon with three or four corners moves, each corner along a
// straight line over the times 0 to 1. When does it first meet the
// origin? The differences between a node and the corners of a face, or
// between the ends of two edges, are such a polygon, and it meets the
// origin when the two touch.
#pragma once
#include <stdbool.h>
#include <stdint.h>

//> Hold a polygon in motion
// Three corners: a triangle, with the parameters (0, 0), (1, 0) and
// (0, 1). Four: a parallelogram, (0, 0), (1, 0), (1, 1) and (0, 1).
struct moving_corner {
    double at[2];       // parameters
    double place[2][3]; // at the beginning and at the end
};

struct moving_polygon {
    int corners; // 3 or 4
    struct moving_corner corner[4];
};
//<

//> Hold where the origin is met
struct origin_hit {
    double time, at[2]; // the parameters of the point that meets it
};
//<

//> Hold a search for the origin
struct origin_search {
    double near;      // closer is reported
    double fine;      // what moves or is wide no more is fine enough
    double allowance; // for the rounding of places and products
    struct origin_hit hit;
    uint64_t pieces; // looked at
};

// Searches a polygon with no coordinate larger than size. Pieces are
// halved in the order of time, so that the first that is reported is
// the earliest. Returns whether one was: then the origin is
// not met before hit.time, and at that time the point of hit.at is
// within the tolerance of it. The tolerance is at least 2^-40 size.
bool search_origin(const struct moving_polygon *polygon, double size,
                   double tolerance, struct origin_search *search);
//<

//> Declare ways to miss the origin
// True only if the origin is certainly not met: if a plane through it,
// upright on n, has the whole motion on one side; if one of the three
// planes of coordinates has; if the plane of the polygon never comes
// over the origin, since four coefficients have one sign. False says
// nothing. The allowance is rounding_allowance of the size.
bool missed_by_plane(const struct moving_polygon *polygon,
                     const double n[3], double allowance);
bool missed_by_box(const struct moving_polygon *polygon,
                   double allowance);
bool missed_by_signs(const struct moving_polygon *polygon, double size);

// The largest coordinate, without its sign; and what rounding can spoil
// at such a size, which is at least MIN_EXACT of exact.h.
double polygon_size(const struct moving_polygon *polygon);
double rounding_allowance(double size);
//<
//<
