// Clouds in which bodies pass through each other, and the broad phase
// of one step, timed.
#include "ch13-contact/experiments/setting.h"
#include "ch13-contact/motion.h"
#include <math.h>

struct simulation cloud_of(uint32_t triangles, bool giant,
                           const struct broad_phase *phase, double dt)
{
    const uint32_t bodies = triangles / TRIANGLES_PER_BODY + 1;
    struct scene scene = build_scene(
        find_built_in(giant ? "giant" : "cloud"), bodies, 1);
    struct simulation s = simulation_of(scene, phase, dt, 1);
    s.passive = true;
    s.dt = 1;
    for (int step = 0; step < 2; step++) {
        scene_predict(&s.scene, s.dt, 1);
        go_on(&s);
    }
    s.dt = dt;
    return s;
}

double time_broad(struct simulation *s)
{
    scene_predict(&s->scene, s->dt, s->threads);
    capture(&s->boxes, &s->scene, s->tolerance, s->threads);
    const struct broad_search search = {&s->boxes, s->scene.group,
                                        &s->pairs, s->threads};
    const int64_t start = clock_ns();
    find_pairs(s->broad_phase, s->kept, &search);
    return (double)(clock_ns() - start);
}

// A body that leaves the space in which all began turns round.
static void turn_round(struct body *body, double side)
{
    for (int k = 0; k < 3; k++)
        if ((body->position[k] < 0 && body->velocity[k] < 0) ||
            (body->position[k] > side && body->velocity[k] > 0))
            body->velocity[k] *= -1;
}

void go_on(struct simulation *s)
{
    const double side = 2 * ceil(cbrt(s->scene.bodies)) - 2;
    for (uint32_t b = 0; b < s->scene.bodies; b++) {
        struct body *body = &s->scene.body[b];
        if (body->motion != RIGID)
            continue;
        const struct pose pose = pose_after(body, s->dt);
        memcpy(body->position, pose.position, sizeof pose.position);
        memcpy(body->orientation, pose.orientation,
               sizeof pose.orientation);
        turn_round(body, side);
    }
    for (int k = 0; k < 3; k++)
        memcpy(s->scene.mesh.x[k], s->scene.predicted[k],
               s->scene.mesh.nodes * sizeof(double));
}
