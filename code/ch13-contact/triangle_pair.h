//> Declare the test of two triangles
// Do two triangles share a point? Decided exactly, by the signs of
// orientations alone: 6 of a node and a face, 9 of two edges. Most
// pairs that do not meet are told by 3 or 6 of them.
#pragma once
#include "ch13-contact/exact.h"

//> Hold a triangle at rest
struct triangle {
    double corner[3][3]; // x, y, z of each
};
//<

// Triangles are closed: to touch is to meet. One whose corners lie on a
// line is that segment, or that point. Coordinates keep to the rule of
// exact.h. Adds to *expanded, unless that is NULL, how many signs
// needed expansions. (After Guigue and Devillers 2003, with more signs
// and fewer cases.)
bool triangles_meet(const struct triangle *p, const struct triangle *q,
                    uint64_t *expanded);
//<
