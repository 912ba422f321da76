//> Push bodies apart
// The simplest response that lets a pile come to rest: no bounce, and
// friction that resists sliding as far as the pressure allows.
#include "ch13-contact/respond.h"
#include "ch13-contact/vectors.h"
#include "common/allocate.h"
#include "common/fail.h"
#include "common/min_max.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

//> Hold the two sides of a touch
// Of a node and a face or of two edges, the first has split nodes.
struct side {
    const uint32_t *node;
    const double *weight;
    int count;
};

static struct side side_of(const struct event *event, int side)
{
    const int split = event->kind == NODE_FACE ? 1 : 2;
    return side == 0 ? (struct side){event->node, event->weight, split}
                     : (struct side){event->node + split,
                                     event->weight + split, 4 - split};
}

// The weighted place of a side, at a time of the step.
static void place_of_side(const struct scene *scene, struct side side,
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

//> Remember events
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

void grow_old(struct touches *touches)
{
    for (uint32_t t = 0; t < touches->count; t++)
        touches->touch[t].age++;
}

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

//> Find a side's velocity
// A rigid body moves at a point as its middle does, and turns around
// that; of a soft one, each node has its weight.
struct lever {
    struct side side;
    struct body *body;
    double arm[3]; // from the middle of a rigid body
};

static struct lever lever_of(const struct scene *scene,
                             const struct event *event, int side)
{
    struct lever lever = {side_of(event, side)};
    const uint32_t b = scene->body_of_node[lever.side.node[0]];
    lever.body = &scene->body[b];
    place_of_side(scene, lever.side, 0, lever.arm);
    for (int k = 0; k < 3; k++)
        lever.arm[k] -= lever.body->place[k];
    return lever;
}

static void velocity_at(const struct scene *scene,
                        const struct lever *lever, double velocity[3])
{
    const struct body *body = lever->body;
    const struct side side = lever->side;
    double turning[3] = {0};
    if (body->motion == RIGID)
        cross(body->spin, lever->arm, turning);
    for (int k = 0; k < 3; k++) {
        velocity[k] =
            body->motion == RIGID ? body->velocity[k] + turning[k] : 0;
        for (int s = 0; s < side.count && body->motion == SOFT; s++)
            velocity[k] +=
                side.weight[s] * scene->velocity[k][side.node[s]];
    }
}
//<

//> Give an impulse to a side
// How much velocity an impulse of 1 in a direction gives, there.
static double give_of(const struct lever *lever, const double along[3])
{
    const struct body *body = lever->body;
    double turn[3], weights2 = 0;
    for (int s = 0; s < lever->side.count; s++)
        weights2 += lever->side.weight[s] * lever->side.weight[s];
    if (body->motion == SOFT)
        return body->lightness * weights2;
    cross(lever->arm, along, turn);
    return body->lightness + body->ease * dot(turn, turn);
}

static void give_impulse(struct scene *scene, const struct lever *lever,
                         const double along[3], double impulse)
{
    struct body *body = lever->body;
    double turn[3];
    cross(lever->arm, along, turn);
    for (int k = 0; k < 3; k++) {
        const double change = impulse * body->lightness * along[k];
        if (body->motion == RIGID) {
            body->velocity[k] += change;
            body->spin[k] += impulse * body->ease * turn[k];
        }
        for (int s = 0; s < lever->side.count && body->motion == SOFT;
             s++)
            scene->velocity[k][lever->side.node[s]] +=
                change * lever->side.weight[s];
    }
}
//<

//> Stop the approach along a direction
// With an impulse of at most so much; says how much it took.
static double stop_along(struct scene *scene,
                         const struct lever lever[2],
                         const double along[3], double most)
{
    double first[3], second[3];
    velocity_at(scene, &lever[0], first);
    velocity_at(scene, &lever[1], second);
    const double speed = dot(first, along) - dot(second, along);
    const double give =
        give_of(&lever[0], along) + give_of(&lever[1], along);
    if (speed >= 0 || give <= 0)
        return 0;
    const double impulse = MIN(-speed / give, most);
    give_impulse(scene, &lever[0], along, impulse);
    give_impulse(scene, &lever[1], along, -impulse);
    return impulse;
}
//<

//> Rub along the plane of a touch
// Against the direction in which the first slides.
static void rub(struct scene *scene, const struct lever lever[2],
                const double normal[3], double most)
{
    double first[3], second[3], against[3];
    velocity_at(scene, &lever[0], first);
    velocity_at(scene, &lever[1], second);
    const double speed = dot(first, normal) - dot(second, normal);
    for (int k = 0; k < 3; k++)
        against[k] = second[k] - first[k] + speed * normal[k];
    const double length = sqrt(dot(against, against));
    if (length <= 0)
        return;
    for (int k = 0; k < 3; k++)
        against[k] /= length;
    stop_along(scene, lever, against, most);
}
//<

//> Go over all touches
void push_apart(const struct touches *touches, struct scene *scene)
{
    for (int round = 0; round < touches->rounds; round++)
        for (uint32_t t = 0; t < touches->count; t++) {
            const struct touch *touch = &touches->touch[t];
            const struct lever lever[2] = {
                lever_of(scene, &touch->event, 0),
                lever_of(scene, &touch->event, 1)};
            const double pressure =
                stop_along(scene, lever, touch->normal, INFINITY);
            rub(scene, lever, touch->normal,
                touches->friction * pressure);
        }
}
//<
//<
