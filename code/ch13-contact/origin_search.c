//> Find when a polygon meets the origin
// Guess, then prove; if neither succeeds, halve. The guess is the point
// of the polygon that is closest to the origin, as computed, however
// rounded. Either its direction proves that this piece of the motion
// misses the origin, or it is so near that it is reported, or the piece
// is halved: in time, and in place when it hardly moves any more. A
// piece costs 150 to 250 operations, and there are at most some 135
// halvings one after the other.
#include "ch13-contact/origin_search.h"
#include "ch13-contact/closest_point.h"
#include "ch13-contact/vectors.h"
#include "common/min_max.h"
#include <assert.h>

//> Hold a piece of the motion
// Of the polygon a part, over a part of the time.
struct piece {
    double time[2];
    struct moving_polygon moving; // with places at these two times
    bool cut; // in place: its time is halved no more
};
//<

//> Take a polygon at one time
// At the beginning, share 0, or in the middle, 0.5.
static struct polygon polygon_at(const struct moving_polygon *moving,
                                 double share)
{
    struct polygon polygon = {moving->corners, {{0}}};
    for (int k = 0; k < moving->corners; k++)
        for (int x = 0; x < 3; x++)
            polygon.place[k][x] =
                (1 - share) * moving->corner[k].place[0][x] +
                share * moving->corner[k].place[1][x];
    return polygon;
}
//<

//> Report a point that is near
// Its weights are in [0, 1] or all but, so it is a point of the polygon
// but for rounding, whichever way it was found.
static bool report(const struct piece *piece,
                   const struct closest_point *point,
                   struct origin_search *search)
{
    if (dot(point->place, point->place) > search->near * search->near)
        return false;
    const struct moving_corner *corner = piece->moving.corner;
    const double *a = corner[point->corner[0]].at;
    const double *b = corner[point->corner[1]].at;
    const double *c = corner[point->corner[2]].at;
    search->hit.time = piece->time[0];
    for (int k = 0; k < 2; k++)
        search->hit.at[k] = a[k] + point->weight[0] * (b[k] - a[k]) +
                            point->weight[1] * (c[k] - a[k]);
    return true;
}
//<

//> Measure how far a piece moves
static double motion_of(const struct moving_polygon *moving)
{
    double motion = 0;
    for (int k = 0; k < moving->corners; k++) {
        double way[3];
        subtract(moving->corner[k].place[1], moving->corner[k].place[0],
                 way);
        const double distance = largest(way);
        motion = MAX(motion, distance);
    }
    return motion;
}
//<

static bool find(const struct piece *piece,
                 struct origin_search *search);

//> Halve a piece in time
static bool bisect_time(const struct piece *piece,
                        struct origin_search *search)
{
    struct piece sooner = *piece, later = *piece;
    sooner.time[1] = later.time[0] =
        (piece->time[0] + piece->time[1]) / 2;
    const struct polygon middle = polygon_at(&piece->moving, 0.5);
    for (int k = 0; k < middle.corners; k++)
        for (int x = 0; x < 3; x++)
            sooner.moving.corner[k].place[1][x] =
                later.moving.corner[k].place[0][x] = middle.place[k][x];
    return find(&sooner, search) || find(&later, search);
}
//<

//> Find the middle of two corners
static struct moving_corner middle_of(const struct moving_corner *a,
                                      const struct moving_corner *b)
{
    struct moving_corner middle;
    for (int k = 0; k < 2; k++)
        middle.at[k] = (a->at[k] + b->at[k]) / 2;
    for (int end = 0; end < 2; end++)
        for (int x = 0; x < 3; x++)
            middle.place[end][x] =
                (a->place[end][x] + b->place[end][x]) / 2;
    return middle;
}
//<

//> Halve a piece in place
// A triangle from its corner 0 to the middle, 3, of the side across; a
// parallelogram from the middle, 4, of its first side to that, 5, of
// the third. The halves' corners are in such an order that two such
// cuts halve all sides.
static bool bisect_place(const struct piece *piece,
                         struct origin_search *search)
{
    static const int half[2][2][4] = {{{3, 0, 1}, {3, 2, 0}},
                                      {{4, 5, 3, 0}, {1, 2, 5, 4}}};
    const int corners = piece->moving.corners;
    struct moving_corner corner[6];
    for (int k = 0; k < corners; k++)
        corner[k] = piece->moving.corner[k];
    if (corners == 3) {
        corner[3] = middle_of(&corner[1], &corner[2]);
    } else {
        corner[4] = middle_of(&corner[0], &corner[1]);
        corner[5] = middle_of(&corner[2], &corner[3]);
    }
    for (int h = 0; h < 2; h++) {
        struct piece part = *piece;
        part.cut = true;
        for (int k = 0; k < corners; k++)
            part.moving.corner[k] = corner[half[corners - 3][h][k]];
        if (find(&part, search))
            return true;
    }
    return false;
}
//<

//> Give up, report, or halve a piece
// Once a piece is cut in place, all its parts begin at one time, so
// that the first report is the earliest of all.
// Never without end: a piece that moves by no more than fine, with
// sides no longer than that, is less than 3 fine wide. If its box does
// not miss the origin, all of it is near.
static bool find(const struct piece *piece,
                 struct origin_search *search)
{
    search->pieces++;
    if (missed_by_box(&piece->moving, search->allowance))
        return false;
    const struct polygon middle = polygon_at(&piece->moving, 0.5);
    const struct closest_point guess = closest_to_origin(&middle);
    if (missed_by_plane(&piece->moving, guess.normal,
                        search->allowance))
        return false;
    const struct polygon first = polygon_at(&piece->moving, 0);
    const struct closest_point point = closest_to_origin(&first);
    if (report(piece, &point, search))
        return true;
    return !piece->cut && motion_of(&piece->moving) > search->fine
               ? bisect_time(piece, search)
               : bisect_place(piece, search);
}
//<

//> Search for the origin
bool search_origin(const struct moving_polygon *moving, double size,
                   double tolerance, struct origin_search *search)
{
    assert(tolerance >= 0x1p-40 * size && "or halving has no end");
    search->near = 0.875 * tolerance;
    search->fine = 0.125 * tolerance;
    search->allowance = rounding_allowance(size);
    const struct piece all = {{0, 1}, *moving, false};
    return find(&all, search);
}
//<
//<
