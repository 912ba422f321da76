//> Declare the test by axes
// Most candidates only have boxes that meet. Two moving triangles are
// apart all the while if along some direction, a separating axis, one
// is behind the other, at the beginning and at the end: twelve corners,
// no time in between.
#pragma once
#include "ch13-contact/events.h"
#include <stdbool.h>

// Whether one of 12 directions shows that the two have no event at this
// tolerance: from middle to middle, the two normals, and products of
// edges, one of each. If triangles do not touch, one of the last 11
// separates them (Gottschalk 1996), and goes on to if they move little.
// False says nothing.
bool has_separating_axis(const struct moving_triangle *p,
                         const struct moving_triangle *q,
                         double tolerance);
//<
