//> Solve the contacts
// The simplest response that lets a pile come to rest: no bounce, and
// friction that resists sliding as far as the pressure allows. Each
// round costs time in proportion to the contacts. Rounds do not solve
// all contacts at once, they only come near to it; nothing crosses all
// the same, since the search sees to that.
#include "ch13-contact/respond.h"
#include "ch13-contact/vectors.h"
#include "common/min_max.h"
#include <math.h>

//> Hold a side of a contact
// A rigid body moves at a point as its middle does, and turns around
// that; of a soft one, each node has its weight.
struct contact_side {
    struct feature feature;
    struct body *body;
    double arm[3]; // from the middle of a rigid body to the point
};

static struct contact_side side_of(const struct scene *scene,
                                   const struct event *event, int which)
{
    struct contact_side side = {feature_of(event, which)};
    const uint32_t b = scene->body_of_node[side.feature.node[0]];
    side.body = &scene->body[b];
    feature_position(scene, side.feature, 0, side.arm);
    for (int k = 0; k < 3; k++)
        side.arm[k] -= side.body->position[k];
    return side;
}
//<

//> Add up motion and turning
static void velocity_at(const struct scene *scene,
                        const struct contact_side *side,
                        double velocity[3])
{
    const struct body *body = side->body;
    const struct feature feature = side->feature;
    double turning[3] = {0};
    if (body->motion == RIGID)
        cross(body->angular_velocity, side->arm, turning);
    for (int k = 0; k < 3; k++) {
        velocity[k] =
            body->motion == RIGID ? body->velocity[k] + turning[k] : 0;
        for (int f = 0; f < feature.count && body->motion == SOFT; f++)
            velocity[k] +=
                feature.weight[f] * scene->velocity[k][feature.node[f]];
    }
}
//<

//> Apply an impulse to a side
// How much velocity an impulse of 1 along a direction gives to the
// point: the inverse of the mass that the impulse seems to meet there.
static double mobility(const struct contact_side *side,
                       const double along[3])
{
    const struct body *body = side->body;
    double turning[3], weights2 = 0;
    for (int f = 0; f < side->feature.count; f++)
        weights2 += side->feature.weight[f] * side->feature.weight[f];
    if (is_held(body))
        return 0;
    if (body->motion == SOFT)
        return body->inverse_mass * weights2;
    cross(side->arm, along, turning);
    return body->inverse_mass +
           body->inverse_inertia * dot(turning, turning);
}

static void apply_impulse(struct scene *scene,
                          const struct contact_side *side,
                          const double along[3], double impulse)
{
    struct body *body = side->body;
    const struct feature feature = side->feature;
    double turning[3];
    cross(side->arm, along, turning);
    for (int k = 0; k < 3; k++) {
        const double change = impulse * body->inverse_mass * along[k];
        if (body->motion == RIGID) {
            body->velocity[k] += change;
            body->angular_velocity[k] +=
                impulse * body->inverse_inertia * turning[k];
        }
        for (int f = 0; f < feature.count && body->motion == SOFT; f++)
            scene->velocity[k][feature.node[f]] +=
                change * feature.weight[f];
    }
}
//<

//> Stop the approach along a direction
// With an impulse of at most so much; says how much it took.
static double stop_along(struct scene *scene,
                         const struct contact_side side[2],
                         const double along[3], double max_impulse)
{
    double first[3], second[3];
    velocity_at(scene, &side[0], first);
    velocity_at(scene, &side[1], second);
    const double speed = dot(first, along) - dot(second, along);
    const double both =
        mobility(&side[0], along) + mobility(&side[1], along);
    if (speed >= 0 || both <= 0)
        return 0;
    const double impulse = MIN(-speed / both, max_impulse);
    apply_impulse(scene, &side[0], along, impulse);
    apply_impulse(scene, &side[1], along, -impulse);
    return impulse;
}
//<

//> Apply friction
// Against the direction in which the first slides.
static void apply_friction(struct scene *scene,
                           const struct contact_side side[2],
                           const double normal[3], double max_impulse)
{
    double first[3], second[3], against[3];
    velocity_at(scene, &side[0], first);
    velocity_at(scene, &side[1], second);
    const double speed = dot(first, normal) - dot(second, normal);
    for (int k = 0; k < 3; k++)
        against[k] = second[k] - first[k] + speed * normal[k];
    const double length = sqrt(dot(against, against));
    if (length <= 0)
        return;
    for (int k = 0; k < 3; k++)
        against[k] /= length;
    stop_along(scene, side, against, max_impulse);
}
//<

//> Go over all contacts
void solve_contacts(const struct contact_cache *cache,
                    struct scene *scene)
{
    for (int round = 0; round < cache->rounds; round++)
        for (uint32_t c = 0; c < cache->count; c++) {
            const struct contact *contact = &cache->contact[c];
            uint32_t two[2];
            bodies_of_contact(contact, scene, two);
            if (is_held(&scene->body[two[0]]) &&
                is_held(&scene->body[two[1]]))
                continue;
            const struct contact_side side[2] = {
                side_of(scene, &contact->event, 0),
                side_of(scene, &contact->event, 1)};
            const double pressure =
                stop_along(scene, side, contact->normal, INFINITY);
            apply_friction(scene, side, contact->normal,
                           cache->friction * pressure);
        }
}
//<
//<
