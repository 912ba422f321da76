//> Guess the closest point of a polygon
// First the point of its plane that is closest to the origin; if that
// is outside, the best of its sides. A few hundred operations at most,
// none of them safe from rounding: on a sliver the point may be far
// from right.
#include "ch13-contact/closest_point.h"
#include "ch13-contact/vectors.h"
#include <stdbool.h>

//> Put a point where its weights say
static void put_point(const struct polygon *p,
                      struct closest_point *point)
{
    const double *a = p->place[point->corner[0]];
    const double *b = p->place[point->corner[1]];
    const double *c = p->place[point->corner[2]];
    for (int x = 0; x < 3; x++)
        point->place[x] = a[x] + point->weight[0] * (b[x] - a[x]) +
                          point->weight[1] * (c[x] - a[x]);
}
//<

//> Drop a perpendicular into the polygon
// The point of its plane nearest to the origin, if that is in it: then
// the way there is upright on both sides, which are two equations for
// two weights. Where it is a line or all but, a millionth as wide as it
// is long, that is left to its sides.
static bool closest_inside(const struct polygon *p,
                           struct closest_point *point)
{
    const int last = p->corners - 1;
    double s[3], t[3];
    subtract(p->place[1], p->place[0], s);
    subtract(p->place[last], p->place[0], t);
    const double ss = dot(s, s), st = dot(s, t), tt = dot(t, t);
    const double so = -dot(s, p->place[0]), to = -dot(t, p->place[0]);
    const double area2 = ss * tt - st * st;
    const double i = (so * tt - to * st) / area2;
    const double j = (to * ss - so * st) / area2;
    *point = (struct closest_point){.corner = {0, 1, last},
                                    .weight = {i, j}};
    put_point(p, point);
    cross(s, t, point->normal);
    return area2 > 0x1p-40 * ss * tt && i >= 0 && j >= 0 &&
           (last == 2 ? i + j <= 1 : i <= 1 && j <= 1);
}
//<

//> Drop a perpendicular on a side
// Its foot, or the end that is nearer to the origin. The way to the
// foot, a small difference of large numbers, is not quite upright on
// the side; so what it has along the side is taken away once more.
static struct closest_point closest_on_side(const struct polygon *p,
                                            int a, int b)
{
    double side[3];
    subtract(p->place[b], p->place[a], side);
    const double side2 = dot(side, side);
    double weight = 0, along = 0;
    if (side2 > 0)
        weight = fmin(1, fmax(0, -dot(p->place[a], side) / side2));
    struct closest_point point = {.corner = {a, b, a},
                                  .weight = {weight}};
    put_point(p, &point);
    if (weight > 0 && weight < 1)
        along = dot(point.place, side) / side2;
    for (int x = 0; x < 3; x++)
        point.normal[x] = point.place[x] - along * side[x];
    return point;
}
//<

//> Find the closest point of the polygon
struct closest_point closest_to_origin(const struct polygon *p)
{
    struct closest_point best;
    if (closest_inside(p, &best))
        return best;
    double best2 = INFINITY;
    for (int a = 0; a < p->corners; a++) {
        const struct closest_point point =
            closest_on_side(p, a, (a + 1) % p->corners);
        const double d2 = dot(point.place, point.place);
        if (d2 < best2)
            best = point, best2 = d2;
    }
    return best;
}
//<
//<
