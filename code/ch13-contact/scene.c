//> Move bodies
// The order of a step's parts is that of Euler's second method: first
// the velocities, then with these the places. It neither gains nor
// loses energy for long.
#include "ch13-contact/scene.h"
#include "ch13-contact/exact.h"
#include "ch13-contact/vectors.h"
#include "common/allocate.h"
#include "common/fail.h"
#include "common/min_max.h"
#include "common/points.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

//> Weigh a body
// As heavy as the box around its nodes at density 1, and turned as
// easily as a ball of that mass and of their mean squared distance.
static void weigh(struct scene *scene, struct body *body)
{
    const uint32_t begin = body->begin.node, end = body->end.node;
    double volume = 1, distance2 = 0;
    for (int k = 0; k < 3; k++) {
        const double *x = scene->mesh.x[k];
        double low = x[begin], high = x[begin];
        for (uint32_t i = begin; i < end; i++) {
            low = MIN(low, x[i]);
            high = MAX(high, x[i]);
            distance2 += x[i] * x[i] / (end - begin);
        }
        volume *= high - low;
    }
    const double mass = volume > 0 ? volume : 1;
    const double inertia = 0.4 * mass * distance2;
    body->lightness = 1 / mass;
    body->ease = inertia > 0 ? 1 / inertia : 0;
}
//<

//> Move a body's middle to the origin
// Says where it was: the mean of the nodes.
static void center(struct mesh *mesh, struct mesh_end since,
                   double middle[3])
{
    for (int k = 0; k < 3; k++) {
        const uint32_t count = mesh->nodes - since.node;
        double sum = 0;
        for (uint32_t i = since.node; i < mesh->nodes; i++)
            sum += mesh->x[k][i];
        middle[k] = count > 0 ? sum / count : 0;
        for (uint32_t i = since.node; i < mesh->nodes; i++)
            mesh->x[k][i] -= middle[k];
    }
}
//<

//> Add a body to a scene
static void enlarge(struct scene *scene)
{
    scene->room = 2 * scene->room + 16;
    struct body *more = allocate(scene->room, sizeof *more);
    if (scene->bodies)
        memcpy(more, scene->body, scene->bodies * sizeof *more);
    free(scene->body);
    scene->body = more;
}

void scene_add(struct scene *scene, struct mesh_end since,
               const struct start *start)
{
    struct mesh *mesh = &scene->mesh;
    if (scene->bodies == scene->room)
        enlarge(scene);
    struct body *body = &scene->body[scene->bodies++];
    *body = (struct body){start->motion, since, mesh_end(mesh),
                          .turn = {1}};
    double middle[3] = {0};
    if (body->motion == RIGID)
        center(mesh, since, middle);
    const double size = start->size > 0 ? start->size : 1;
    for (int k = 0; k < 3; k++) {
        for (uint32_t i = since.node; i < mesh->nodes; i++)
            mesh->x[k][i] *= size;
        body->place[k] = start->place[k] + size * middle[k];
        body->velocity[k] = start->velocity[k];
        body->spin[k] = start->spin[k];
    }
    if (body->motion == RIGID)
        weigh(scene, body);
}
//<

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

//> Make room for what moves
static void give_arrays(struct scene *scene)
{
    const struct mesh *mesh = &scene->mesh;
    for (int k = 0; k < 3; k++) {
        const size_t bytes = mesh->nodes * sizeof(double);
        scene->end[k] = allocate(bytes, 1);
        scene->rest[k] = allocate(bytes, 1);
        scene->velocity[k] = allocate(bytes, 1);
        memcpy(scene->rest[k], mesh->x[k], bytes);
    }
    scene->body_of_node = allocate(mesh->nodes, sizeof(uint32_t));
    scene->body_of = allocate(mesh->triangles, sizeof(uint32_t));
    scene->group = allocate(mesh->triangles, sizeof(uint32_t));
}

void scene_complete(struct scene *scene)
{
    give_arrays(scene);
    uint32_t fixed = NO_INDEX - 1; // the group of all of them
    for (uint32_t b = 0; b < scene->bodies; b++) {
        const struct body *body = &scene->body[b];
        for (uint32_t i = body->begin.node; i < body->end.node; i++) {
            scene->body_of_node[i] = b;
            for (int k = 0; k < 3; k++)
                scene->velocity[k][i] = body->velocity[k];
        }
        for (uint32_t t = body->begin.triangle; t < body->end.triangle;
             t++) {
            scene->body_of[t] = b;
            scene->group[t] = body->motion == FIXED   ? fixed
                              : body->motion == RIGID ? b
                                                      : NO_INDEX;
        }
        const struct pose pose = pose_after(body, 0);
        place_nodes(scene, body, &pose, scene->mesh.x);
        place_nodes(scene, body, &pose, scene->end);
    }
}
//<

void scene_free(struct scene *scene)
{
    mesh_free(&scene->mesh);
    for (int k = 0; k < 3; k++) {
        free(scene->end[k]);
        free(scene->rest[k]);
        free(scene->velocity[k]);
    }
    free(scene->body_of_node);
    free(scene->body_of);
    free(scene->group);
    free(scene->body);
    *scene = (struct scene){0};
}

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
