//> Decide whether two triangles meet
// Fifteen signs tell all: of the three nodes of each against the face
// of the other, and of three edges against three edges. The cases are
// three: one triangle is on one side of the other; an edge goes through
// a face; or all is in one plane, and its projections decide. A sign
// costs some 30 operations, where the filter of exact.h decides it.
#include "ch13-contact/triangle_pair.h"
#include <assert.h>
#include <math.h>

//> Walk around a triangle
static const int NEXT[3] = {1, 2, 0}, LAST[3] = {2, 0, 1};
//<

//> Compare three signs
static bool all_are(const int sign[3], int value)
{
    return sign[0] == value && sign[1] == value && sign[2] == value;
}

static bool one_sided(const int sign[3])
{
    return all_are(sign, 1) || all_are(sign, -1);
}

// Whether a + and a - are among them.
static bool differ(int a, int b, int c)
{
    return (a > 0 || b > 0 || c > 0) && (a < 0 || b < 0 || c < 0);
}
//<

//> Find the sides of three nodes
static void node_orientations(const struct triangle *node,
                              const struct triangle *face, int side[3],
                              uint64_t *expanded)
{
    for (int k = 0; k < 3; k++)
        side[k] =
            orientation3(face->corner[0], face->corner[1],
                         face->corner[2], node->corner[k], expanded);
}
//<

//> Find how edges pass each other
// The edge i of p, from its corner i to the next, and the edge j of q.
// Seen so that the edge of q comes straight towards the eye, it passes
// to the left of the edge of p, 1, or to its right, -1; 0 if the two
// lie in a plane.
static void edge_orientations(const struct triangle *p,
                              const struct triangle *q, int turn[3][3],
                              uint64_t *expanded)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            turn[i][j] = orientation3(p->corner[i], p->corner[NEXT[i]],
                                      q->corner[j], q->corner[NEXT[j]],
                                      expanded);
}
//<

//> Separate two projections by a line
// Whether the line through an edge of the first has the other strictly
// on one side, and the first nowhere on that side.
static bool edge_separates(const double p[3][2], const double q[3][2],
                           uint64_t *expanded)
{
    for (int i = 0; i < 3; i++) {
        int side[3];
        for (int j = 0; j < 3; j++)
            side[j] = orientation2(p[i], p[NEXT[i]], q[j], expanded);
        if (one_sided(side) &&
            orientation2(p[i], p[NEXT[i]], p[LAST[i]], expanded) !=
                side[0])
            return true;
    }
    return false;
}

static bool projections_meet(const struct triangle *p,
                             const struct triangle *q, int axis,
                             uint64_t *expanded)
{
    double a[3][2], b[3][2];
    for (int k = 0; k < 3; k++) {
        a[k][0] = p->corner[k][NEXT[axis]];
        a[k][1] = p->corner[k][LAST[axis]];
        b[k][0] = q->corner[k][NEXT[axis]];
        b[k][1] = q->corner[k][LAST[axis]];
    }
    return !edge_separates((const double(*)[2])a, (const double(*)[2])b,
                           expanded) &&
           !edge_separates((const double(*)[2])b, (const double(*)[2])a,
                           expanded);
}
//<

//> Compare boxes of two triangles
static bool own_boxes_meet(const struct triangle *p,
                           const struct triangle *q)
{
    for (int k = 0; k < 3; k++) {
        double min[2], max[2];
        const struct triangle *of[2] = {p, q};
        for (int i = 0; i < 2; i++) {
            const double a = of[i]->corner[0][k];
            const double b = of[i]->corner[1][k];
            const double c = of[i]->corner[2][k];
            min[i] = fmin(a, fmin(b, c));
            max[i] = fmax(a, fmax(b, c));
        }
        if (max[0] < min[1] || max[1] < min[0])
            return false;
    }
    return true;
}
//<

//> Decide in one plane
// What lies in one plane meets if its three projections do, on the
// planes of coordinates: at least one of these is not squeezed to a
// line. Two projections are apart if the line through an edge tells
// them apart or, where both lie on a line, their boxes.
static bool coplanar_meet(const struct triangle *p,
                          const struct triangle *q, uint64_t *expanded)
{
    return own_boxes_meet(p, q) &&
           projections_meet(p, q, 0, expanded) &&
           projections_meet(p, q, 1, expanded) &&
           projections_meet(p, q, 2, expanded);
}
//<

//> Look for an edge through a face
// An edge whose ends have different sides crosses the plane of the
// other face in one point. It is in the face if the edge does not pass
// two of its edges in different ways. If the triangles meet along a
// segment, its ends are two such points.
static bool some_edge_crosses(const int p_side[3], const int q_side[3],
                              int turn[3][3])
{
    for (int k = 0; k < 3; k++) {
        if (p_side[k] != p_side[NEXT[k]] &&
            !differ(turn[k][0], turn[k][1], turn[k][2]))
            return true;
        if (q_side[k] != q_side[NEXT[k]] &&
            !differ(turn[0][k], turn[1][k], turn[2][k]))
            return true;
    }
    return false;
}
//<

//> Check that a triangle can be decided
static bool in_range(const struct triangle *p)
{
    return within_exact_bounds(p->corner[0], 3) &&
           within_exact_bounds(p->corner[1], 3) &&
           within_exact_bounds(p->corner[2], 3);
}
//<

//> Decide whether triangles meet
// A triangle that is a segment or a point has no side: its plane says 0
// of all. If both say 0 of all, either all lies in one plane, or both
// are segments that pass each other, as some turn tells.
bool triangles_meet(const struct triangle *p, const struct triangle *q,
                    uint64_t *expanded)
{
    assert(in_range(p) && in_range(q) && "see exact.h");
    int p_side[3], q_side[3], turn[3][3];
    node_orientations(p, q, p_side, expanded);
    if (one_sided(p_side))
        return false;
    node_orientations(q, p, q_side, expanded);
    if (one_sided(q_side))
        return false;
    edge_orientations(p, q, turn, expanded);
    if (!all_are(p_side, 0) || !all_are(q_side, 0))
        return some_edge_crosses(p_side, q_side, turn);
    return all_are(turn[0], 0) && all_are(turn[1], 0) &&
           all_are(turn[2], 0) && coplanar_meet(p, q, expanded);
}
//<
//<
