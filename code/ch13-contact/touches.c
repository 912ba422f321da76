//> Remember what touches
// What touched once will touch again: gravity pulls anew in each step.
#include "ch13-contact/touches.h"
#include "ch13-contact/vectors.h"
#include "common/allocate.h"
#include "common/fail.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

//> Find the two sides of a touch
struct side side_of(const struct event *event, int side)
{
    const int split = event->kind == NODE_FACE ? 1 : 2;
    return side == 0 ? (struct side){event->node, event->weight, split}
                     : (struct side){event->node + split,
                                     event->weight + split, 4 - split};
}

void bodies_of_touch(const struct touch *touch,
                     const struct scene *scene, uint32_t two[2])
{
    for (int side = 0; side < 2; side++)
        two[side] =
            scene->body_of_node[side_of(&touch->event, side).node[0]];
}

// The weighted place of a side, at a time of the step.
void place_of_side(const struct scene *scene, struct side side,
                   double time, double place[3])
{
    for (int k = 0; k < 3; k++) {
        place[k] = 0;
        for (int s = 0; s < side.count; s++) {
            const double a = scene->mesh.x[k][side.node[s]];
            const double b = scene->end[k][side.node[s]];
            place[k] += side.weight[s] * (a + time * (b - a));
        }
    }
}
//<

//> Find the normal of a touch
// From one node to another at that time.
static void edge_at(const struct scene *scene, const struct event *e,
                    int from, int to, double edge[3])
{
    for (int k = 0; k < 3; k++) {
        const double *x = scene->mesh.x[k], *end = scene->end[k];
        const uint32_t i = e->node[from], j = e->node[to];
        edge[k] =
            x[j] - x[i] + e->time * (end[j] - x[j] - (end[i] - x[i]));
    }
}

// The plane of the face, or of the two edges, at the time of the touch;
// its side is that on which the first was at the beginning. Parallel
// edges have no plane: then straight away from each other.
static void find_normal(const struct scene *scene,
                        const struct event *e, double normal[3])
{
    double a[3], b[3], first[3], second[3], apart[3];
    const bool face = e->kind == NODE_FACE;
    edge_at(scene, e, face ? 1 : 0, face ? 2 : 1, a);
    edge_at(scene, e, face ? 1 : 2, 3, b);
    cross(a, b, normal);
    place_of_side(scene, side_of(e, 0), 0, first);
    place_of_side(scene, side_of(e, 1), 0, second);
    for (int k = 0; k < 3; k++)
        apart[k] = first[k] - second[k];
    if (dot(normal, normal) <= 1e-12 * dot(a, a) * dot(b, b))
        memcpy(normal, apart, sizeof apart);
    const double length = sqrt(dot(normal, normal));
    const double sign = dot(normal, apart) < 0 ? -1 : 1;
    for (int k = 0; k < 3; k++)
        normal[k] = length > 0 ? sign * normal[k] / length : k == 2;
}
//<

//> Make room for touches
// What is remembered and what is new are both sorted by nodes, so they
// are merged.
static void reserve(struct touches *touches, uint64_t wanted)
{
    if (wanted <= touches->room)
        return;
    if (wanted > UINT32_MAX / 2)
        fail("more touches than can be numbered");
    const uint32_t room = (uint32_t)(wanted + wanted / 2 + 64);
    struct touch *more = allocate(room, sizeof *more);
    if (touches->count)
        memcpy(more, touches->touch, touches->count * sizeof *more);
    free(touches->touch);
    free(touches->other);
    touches->touch = more;
    touches->other = allocate(room, sizeof *more);
    touches->room = room;
}

// What touches a body that sleeps is not searched, and so not seen.
void grow_old(struct touches *touches, const struct scene *scene)
{
    for (uint32_t t = 0; t < touches->count; t++) {
        uint32_t two[2];
        bodies_of_touch(&touches->touch[t], scene, two);
        touches->touch[t].age += scene->body[two[0]].motion != ASLEEP &&
                                 scene->body[two[1]].motion != ASLEEP;
    }
}
//<

//> Merge what is remembered with what is new
void remember(struct touches *touches, const struct scene *scene,
              const struct events *events)
{
    const struct event_list *fresh = &events->all;
    reserve(touches, touches->count + fresh->count);
    uint32_t old = 0, kept = 0;
    uint64_t e = 0;
    while (old < touches->count || e < fresh->count) {
        const struct touch *t = &touches->touch[old];
        const int order =
            old == touches->count ? 1
            : e == fresh->count
                ? -1
                : compare_features(&t->event, &fresh->event[e]);
        struct touch *to = &touches->other[kept];
        if (order < 0) {
            *to = *t;
            kept += to->age <= touches->life;
        } else {
            to->event = fresh->event[e++];
            to->age = 0;
            find_normal(scene, &to->event, to->normal);
            kept++;
        }
        old += order <= 0;
    }
    struct touch *swap = touches->touch;
    touches->touch = touches->other;
    touches->other = swap;
    touches->count = kept;
}
//<

void touches_free(struct touches *touches)
{
    free(touches->touch);
    free(touches->other);
    *touches = (struct touches){0};
}
//<
