//> Build a scene
// Bodies are weighed when they are added, and put in their places when
// all are there.
#include "ch13-contact/scene.h"
#include "ch13-contact/enlarge.h"
#include "ch13-contact/motion.h"
#include "common/min_max.h"
#include "common/points.h"
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
    body->inverse_mass = 1 / mass;
    body->inverse_inertia = inertia > 0 ? 1 / inertia : 0;
}
//<

//> Move a body's middle to the origin
// Says where it was: the mean of the nodes.
static void center(struct mesh *mesh, struct mesh_mark since,
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
void scene_add(struct scene *scene, struct mesh_mark since,
               const struct initial_state *initial)
{
    struct mesh *mesh = &scene->mesh;
    if (scene->bodies == scene->room) {
        scene->room = 2 * scene->room + 16;
        scene->body = enlarge(scene->body, scene->bodies, scene->room,
                              sizeof *scene->body);
    }
    struct body *body = &scene->body[scene->bodies++];
    *body = (struct body){initial->motion, since, mesh_mark(mesh),
                          .orientation = {1}};
    double middle[3] = {0};
    if (body->motion == RIGID)
        center(mesh, since, middle);
    const double size = initial->size > 0 ? initial->size : 1;
    for (int k = 0; k < 3; k++) {
        for (uint32_t i = since.node; i < mesh->nodes; i++)
            mesh->x[k][i] *= size;
        body->position[k] = initial->position[k] + size * middle[k];
        body->velocity[k] = initial->velocity[k];
        body->angular_velocity[k] = initial->angular_velocity[k];
    }
    if (body->motion == RIGID)
        weigh(scene, body);
}
//<

//> Make room for what moves
static void give_arrays(struct scene *scene)
{
    const struct mesh *mesh = &scene->mesh;
    for (int k = 0; k < 3; k++) {
        const size_t bytes = mesh->nodes * sizeof(double);
        scene->predicted[k] = allocate(bytes, 1);
        scene->local[k] = allocate(bytes, 1);
        scene->velocity[k] = allocate(bytes, 1);
        memcpy(scene->local[k], mesh->x[k], bytes);
    }
    scene->body_of_node = allocate(mesh->nodes, sizeof(uint32_t));
    scene->body_of = allocate(mesh->triangles, sizeof(uint32_t));
    scene->group = allocate(mesh->triangles, sizeof(uint32_t));
}
//<

//> Put bodies in their places
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
        place_nodes(scene, body, &pose, scene->predicted);
    }
}
//<

void scene_free(struct scene *scene)
{
    mesh_free(&scene->mesh);
    for (int k = 0; k < 3; k++) {
        free(scene->predicted[k]);
        free(scene->local[k]);
        free(scene->velocity[k]);
    }
    free(scene->body_of_node);
    free(scene->body_of);
    free(scene->group);
    free(scene->body);
    *scene = (struct scene){0};
}

//<
