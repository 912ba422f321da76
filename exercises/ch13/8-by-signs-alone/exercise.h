// Exercise: by signs alone
#pragma once
#include <stdbool.h>

// Five points: 0, 1 and 2 are the corners of a triangle, not on a line,
// 3 and 4 the ends of a segment, perhaps equal. Both of these are
// given, are exact, and count. The side of the plane through a, b and c
// where d is: 1 if from there a, b, c are seen to turn left, -1 if
// right, 0 if all four lie in a plane.
int side_of(int a, int b, int c, int d);
// Of three points in the plane of the triangle, seen from where 0, 1, 2
// turn left: 1 if a, b, c turn left, -1 if right, 0 if they lie on a
// line or are not three.
int turn_of(int a, int b, int c);

// Whether the segment and the triangle have a point in common.
bool segment_meets_triangle(void);
