//> Find contact events
// The differences between the two that may touch are a polygon in
// motion, and origin_search.h finds when it meets the origin. Before
// that, two cheap tests dismiss most. A pair of triangles has fifteen
// tests, a search among them costs some 10,000 operations.
#include "ch13-contact/events.h"
#include "ch13-contact/exact.h"
#include "ch13-contact/origin_search.h"
#include <assert.h>
#include <math.h>

//> Keep what is asked within bounds
// The least tolerance as a share of the largest coordinate.
static const double FINEST = 0x1p-40;
//<

//> Put a corner where two points differ
static void put_corner(struct moving_corner *corner,
                       const struct moving *p, const struct moving *q)
{
    for (int x = 0; x < 3; x++) {
        corner->place[0][x] = p->begin[x] - q->begin[x];
        corner->place[1][x] = p->end[x] - q->end[x];
    }
}
//<

//> Search where cheap tests do not dismiss
// No coordinate is larger than size, and size is not so small that
// products of three vanish.
static bool search_polygon(const struct moving_polygon *polygon,
                           double tolerance, struct origin_hit *hit,
                           struct event_counts *counts)
{
    const double size = fmax(polygon_size(polygon), tolerance);
    assert(size <= 2 * MAX_EXACT && tolerance >= MIN_EXACT);
    counts->tests++;
    if (missed_by_box(polygon, rounding_allowance(size))) {
        counts->by_boxes++;
        return false;
    }
    if (missed_by_signs(polygon, size)) {
        counts->by_signs++;
        return false;
    }
    struct origin_search search = {0};
    const bool found = search_origin(
        polygon, size, fmax(tolerance, FINEST * size), &search);
    counts->pieces += search.pieces;
    *hit = search.hit;
    return found;
}
//<

//> Find where a node was at a time
static void add_place(const struct moving *node, double time,
                      double weight, double place[3])
{
    for (int x = 0; x < 3; x++)
        place[x] += weight *
                    ((1 - time) * node->begin[x] + time * node->end[x]);
}
//<

//> Test a node and a face
bool node_meets_face(const struct moving *node,
                     const struct moving face[3], double tolerance,
                     struct event *event, struct event_counts *counts)
{
    struct moving_polygon polygon = {
        3, {{.at = {0, 0}}, {.at = {1, 0}}, {.at = {0, 1}}}};
    for (int k = 0; k < 3; k++)
        put_corner(&polygon.corner[k], node, &face[k]);
    struct origin_hit hit;
    if (!search_polygon(&polygon, tolerance, &hit, counts))
        return false;
    *event = (struct event){
        .kind = NODE_FACE,
        .time = hit.time,
        .weight = {1, 1 - hit.at[0] - hit.at[1], hit.at[0], hit.at[1]}};
    add_place(node, hit.time, 1, event->point);
    return true;
}
//<

//> Test two edges
bool edge_meets_edge(const struct moving p[2], const struct moving q[2],
                     double tolerance, struct event *event,
                     struct event_counts *counts)
{
    struct moving_polygon polygon = {4,
                                     {{.at = {0, 0}},
                                      {.at = {1, 0}},
                                      {.at = {1, 1}},
                                      {.at = {0, 1}}}};
    for (int k = 0; k < 4; k++)
        put_corner(&polygon.corner[k], &p[(int)polygon.corner[k].at[0]],
                   &q[(int)polygon.corner[k].at[1]]);
    struct origin_hit hit;
    if (!search_polygon(&polygon, tolerance, &hit, counts))
        return false;
    *event = (struct event){
        .kind = EDGE_EDGE,
        .time = hit.time,
        .weight = {1 - hit.at[0], hit.at[0], 1 - hit.at[1], hit.at[1]}};
    add_place(&p[0], hit.time, event->weight[0], event->point);
    add_place(&p[1], hit.time, event->weight[1], event->point);
    return true;
}
//<

//> Test the nodes of one triangle
static bool has_node(const struct moving_triangle *q, uint32_t node)
{
    return q->node[0] == node || q->node[1] == node ||
           q->node[2] == node;
}

static size_t node_events(const struct moving_triangle *p,
                          const struct moving_triangle *q,
                          double tolerance, struct event *event,
                          struct event_counts *counts)
{
    size_t n = 0;
    for (int k = 0; k < 3; k++) {
        if (has_node(q, p->node[k]) ||
            !node_meets_face(&p->corner[k], q->corner, tolerance,
                             &event[n], counts))
            continue;
        event[n].node[0] = p->node[k];
        for (int j = 0; j < 3; j++)
            event[n].node[1 + j] = q->node[j];
        n++;
    }
    return n;
}
//<

//> Test all edges of two triangles
static size_t edge_events(const struct moving_triangle *p,
                          const struct moving_triangle *q,
                          double tolerance, struct event *event,
                          struct event_counts *counts)
{
    size_t n = 0;
    for (int pair = 0; pair < 9; pair++) {
        const int a = pair / 3, b = (a + 1) % 3;
        const int c = pair % 3, d = (c + 1) % 3;
        const uint32_t node[4] = {p->node[a], p->node[b], q->node[c],
                                  q->node[d]};
        if (node[0] == node[2] || node[0] == node[3] ||
            node[1] == node[2] || node[1] == node[3])
            continue;
        const struct moving one[2] = {p->corner[a], p->corner[b]};
        const struct moving other[2] = {q->corner[c], q->corner[d]};
        if (!edge_meets_edge(one, other, tolerance, &event[n], counts))
            continue;
        for (int j = 0; j < 4; j++)
            event[n].node[j] = node[j];
        n++;
    }
    return n;
}
//<

//> Find the events of two triangles
size_t triangle_events(const struct moving_triangle *p,
                       const struct moving_triangle *q,
                       double tolerance, struct event event[MAX_EVENTS],
                       struct event_counts *counts)
{
    size_t n = node_events(p, q, tolerance, event, counts);
    n += node_events(q, p, tolerance, event + n, counts);
    return n + edge_events(p, q, tolerance, event + n, counts);
}
//<
//<
