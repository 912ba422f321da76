//> Guess the nearest point of a polygon
#include "ch13-contact/foot.h"
#include "ch13-contact/vectors.h"
#include <stdbool.h>

//> Put a foot where its shares say
static void put_foot(const struct polygon *p, struct foot *foot)
{
    const double *a = p->place[foot->corner[0]];
    const double *b = p->place[foot->corner[1]];
    const double *c = p->place[foot->corner[2]];
    for (int x = 0; x < 3; x++)
        foot->place[x] = a[x] + foot->share[0] * (b[x] - a[x]) +
                         foot->share[1] * (c[x] - a[x]);
}
//<

//> Drop a perpendicular into the polygon
// The point of its plane nearest to the origin, if that is in it: then
// the way there is upright on both sides, which are two equations for
// two shares. Where it is a line or all but, a millionth as wide as it
// is long, that is left to its sides.
static bool foot_inside(const struct polygon *p, struct foot *foot)
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
    *foot = (struct foot){.corner = {0, 1, last}, .share = {i, j}};
    put_foot(p, foot);
    cross(s, t, foot->normal);
    return area2 > 0x1p-40 * ss * tt && i >= 0 && j >= 0 &&
           (last == 2 ? i + j <= 1 : i <= 1 && j <= 1);
}
//<

//> Drop a perpendicular on a side
// Its foot, or the end that is nearer to the origin. The way to the
// foot, a small difference of large numbers, is not quite upright on
// the side; so what it has along the side is taken away once more.
static struct foot foot_on_side(const struct polygon *p, int a, int b)
{
    double side[3];
    subtract(p->place[b], p->place[a], side);
    const double side2 = dot(side, side);
    double share = 0, along = 0;
    if (side2 > 0)
        share = fmin(1, fmax(0, -dot(p->place[a], side) / side2));
    struct foot foot = {.corner = {a, b, a}, .share = {share}};
    put_foot(p, &foot);
    if (share > 0 && share < 1)
        along = dot(foot.place, side) / side2;
    for (int x = 0; x < 3; x++)
        foot.normal[x] = foot.place[x] - along * side[x];
    return foot;
}
//<

//> Find the nearest point of the polygon
struct foot nearest_foot(const struct polygon *p)
{
    struct foot best;
    if (foot_inside(p, &best))
        return best;
    double best2 = INFINITY;
    for (int a = 0; a < p->corners; a++) {
        const struct foot foot =
            foot_on_side(p, a, (a + 1) % p->corners);
        const double d2 = dot(foot.place, foot.place);
        if (d2 < best2)
            best = foot, best2 = d2;
    }
    return best;
}
//<
//<
