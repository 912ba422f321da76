//> Declare the closest point of a polygon
// Of a flat polygon with three or four corners, the point closest to
// the origin: inside of it, on a side, or a corner. It is a guess,
// right but for rounding, and no proof rests on it: what is reported is
// some point of the polygon in any case.
#pragma once

//> Hold a polygon at one time
struct polygon {
    int corners; // 3, or 4: a parallelogram
    double place[4][3];
};
//<

//> Hold a point of a polygon
// Its place is that of corner a, and weight[0] of the way to corner b,
// and weight[1] of the way to corner c.
struct closest_point {
    int corner[3]; // a, b, c
    double weight[2], place[3];
    double normal[3]; // a direction from the origin to there, or back
};
//<

struct closest_point closest_to_origin(const struct polygon *polygon);
//<
