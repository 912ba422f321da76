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
static void turn_by(const double turn[4], const double v[3],
                    double to[3])
{
    double once[3], twice[3];
    cross(turn + 1, v, once);
    cross(turn + 1, once, twice);
    for (int k = 0; k < 3; k++)
        to[k] = v[k] + 2 * (turn[0] * once[k] + twice[k]);
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
        const double rest[3] = {scene->rest[0][i], scene->rest[1][i],
                                scene->rest[2][i]};
        double turned[3];
        turn_by(pose->turn, rest, turned);
        for (int k = 0; k < 3; k++)
            to[k][i] = tame(pose->place[k] + turned[k]);
        if (!exact_range((double[]){to[0][i], to[1][i], to[2][i]}, 3))
            fail("body %u moves too far for exact tests",
                 (unsigned)(body - scene->body));
    }
}
//<

//> Go on for a time
// To turn at this spin is to multiply by (1, dt spin / 2), and then to
// see to it that the length is 1: a step of less than half a turn, the
// slower the further it is.
struct pose pose_after(const struct body *body, double dt)
{
    struct pose pose;
    const double *t = body->turn;
    double half[3], side[3], length2 = 0;
    for (int k = 0; k < 3; k++) {
        pose.place[k] = body->place[k] + dt * body->velocity[k];
        half[k] = 0.5 * dt * body->spin[k];
    }
    cross(half, t + 1, side);
    pose.turn[0] = t[0];
    for (int k = 0; k < 3; k++) {
        pose.turn[0] -= half[k] * t[k + 1];
        pose.turn[k + 1] = t[k + 1] + half[k] * t[0] + side[k];
    }
    for (int k = 0; k < 4; k++)
        length2 += pose.turn[k] * pose.turn[k];
    for (int k = 0; k < 4; k++)
        pose.turn[k] /= sqrt(length2);
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
            scene->end[k][i] =
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
            place_nodes(scene, body, &pose, scene->end);
        if (body->motion == SOFT)
            predict_soft(scene, body, dt);
    }
}
//<
//<
