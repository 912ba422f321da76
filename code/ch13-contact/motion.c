//> Move bodies
// The order of a step's parts is that of Euler's second method: first
// the velocities, then with these the places. It neither gains nor
// loses energy for long.
#include "ch13-contact/motion.h"
#include "ch13-contact/exact.h"
#include "ch13-contact/vectors.h"
#include "common/fail.h"
#include <math.h>

//> Turn by a quaternion
// v + 2 w (q x v) + 2 q x (q x v), where w is the real part.
static void turn_by(const double orientation[4], const double v[3],
                    double to[3])
{
    double once[3], twice[3];
    cross(orientation + 1, v, once);
    cross(orientation + 1, once, twice);
    for (int k = 0; k < 3; k++)
        to[k] = v[k] + 2 * (orientation[0] * once[k] + twice[k]);
}
//<

//> Place the nodes of a body
// Below MIN_EXACT is nothing that an exact test could work with.
static double tame(double x)
{
    return fabs(x) < MIN_EXACT ? 0 : x;
}

void place_nodes(const struct scene *scene, const struct body *body,
                 const struct pose *pose, double *const to[3])
{
    for (uint32_t i = body->begin.node; i < body->end.node; i++) {
        const double local[3] = {scene->local[0][i], scene->local[1][i],
                                 scene->local[2][i]};
        double turned[3];
        turn_by(pose->orientation, local, turned);
        for (int k = 0; k < 3; k++)
            to[k][i] = tame(pose->position[k] + turned[k]);
        if (!within_exact_bounds(
                (double[]){to[0][i], to[1][i], to[2][i]}, 3))
            fail("body %u moves too far for exact tests",
                 (unsigned)(body - scene->body));
    }
}
//<

//> Go on for a time
// To turn at the angular velocity w is to multiply the orientation by
// (1, dt w / 2), and then to make its length 1 again. So a step turns
// by less than half a turn, and a long one by too little.
struct pose pose_after(const struct body *body, double dt)
{
    struct pose pose;
    const double *old = body->orientation;
    double half[3], side[3], length2 = 0;
    for (int k = 0; k < 3; k++) {
        pose.position[k] = body->position[k] + dt * body->velocity[k];
        half[k] = 0.5 * dt * body->angular_velocity[k];
    }
    cross(half, old + 1, side);
    pose.orientation[0] = old[0];
    for (int k = 0; k < 3; k++) {
        pose.orientation[0] -= half[k] * old[k + 1];
        pose.orientation[k + 1] =
            old[k + 1] + half[k] * old[0] + side[k];
    }
    for (int k = 0; k < 4; k++)
        length2 += pose.orientation[k] * pose.orientation[k];
    for (int k = 0; k < 4; k++)
        pose.orientation[k] /= sqrt(length2);
    return pose;
}
//<

//> Let gravity act
void scene_accelerate(struct scene *scene, double dt)
{
    for (uint32_t b = 0; b < scene->bodies; b++) {
        struct body *body = &scene->body[b];
        for (int k = 0; k < 3; k++) {
            const double more = dt * scene->gravity[k];
            if (body->motion == RIGID)
                body->velocity[k] += more;
            if (body->motion == SOFT)
                for (uint32_t i = body->begin.node; i < body->end.node;
                     i++)
                    scene->velocity[k][i] += more;
        }
    }
}
//<

//> Predict the nodes
static void predict_soft(struct scene *scene, const struct body *body,
                         double dt)
{
    for (int k = 0; k < 3; k++)
        for (uint32_t i = body->begin.node; i < body->end.node; i++)
            scene->predicted[k][i] =
                tame(scene->mesh.x[k][i] + dt * scene->velocity[k][i]);
}

void scene_predict(struct scene *scene, double dt, int threads)
{
#pragma omp parallel for num_threads(threads) if (threads > 1) \
    schedule(dynamic, 64)
    for (uint32_t b = 0; b < scene->bodies; b++) {
        const struct body *body = &scene->body[b];
        const struct pose pose = pose_after(body, dt);
        if (body->motion == RIGID)
            place_nodes(scene, body, &pose, scene->predicted);
        if (body->motion == SOFT)
            predict_soft(scene, body, dt);
    }
}
//<
//<
