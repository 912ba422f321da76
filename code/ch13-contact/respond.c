//> Push bodies apart
// The simplest response that lets a pile come to rest: no bounce, and
// friction that resists sliding as far as the pressure allows.
#include "ch13-contact/respond.h"
#include "ch13-contact/vectors.h"
#include "common/min_max.h"
#include <math.h>

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
//<

//> Add up motion and turning
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
    if (is_held(body))
        return 0;
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
            uint32_t two[2];
            bodies_of_touch(touch, scene, two);
            if (is_held(&scene->body[two[0]]) &&
                is_held(&scene->body[two[1]]))
                continue;
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
