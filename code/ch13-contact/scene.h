//> Declare the scene
// Bodies and how they move. A rigid body is where its middle is,
// turned; of a soft one, each node moves on its own; a fixed one stays,
// and so does one that sleeps, a rigid one at rest (sleep.h).
#pragma once
#include "ch13-contact/mesh.h"
#include <stdbool.h>

//> Hold a body
enum motion { FIXED, RIGID, SOFT, ASLEEP };

struct body {
    enum motion motion;
    struct mesh_end begin, end; // its nodes and triangles
    double place[3];            // of its middle
    double turn[4];             // a quaternion of length 1, real first
    double velocity[3], spin[3];
    double lightness; // 1 / mass, 0 if fixed
    double ease;      // 1 / moment of inertia: how easily it is turned
};

// Whether it stays, whatever comes.
static inline bool is_held(const struct body *body)
{
    return body->motion == FIXED || body->motion == ASLEEP;
}
//<

//> Hold a scene
struct scene {
    struct mesh mesh;    // the nodes' places at the time t
    double *end[3];      // their places at t + dt, as predicted
    double *rest[3];     // in an unturned body, from its middle
    double *velocity[3]; // of the nodes of soft bodies
    uint32_t *body_of;   // of each triangle
    uint32_t *body_of_node;
    uint32_t *group; // of each triangle: see scene_complete
    struct body *body;
    uint32_t bodies, room;
    double gravity[3];
};
//<

//> Say how a body begins
// {0}: a rigid one, at rest at the origin, as large as its shape.
struct start {
    enum motion motion;
    double size; // its shape is made so much larger
    double place[3], velocity[3], spin[3];
};
//<

// Makes a body of what the scene's mesh has got since, around the
// origin: it is made larger, and then moved to its place. A rigid body
// is as heavy as the box around it and turns about the mean of its
// nodes; that it turns as easily in all directions, as a ball does, is
// a simplification.
void scene_add(struct scene *scene, struct mesh_end since,
               const struct start *start);

// To be called once, when all bodies are there: makes room for what
// moves. Two triangles of the same group cannot touch: those of a rigid
// body are one, those of all fixed bodies are one; a triangle of a soft
// body is in no group, NO_INDEX.
void scene_complete(struct scene *scene);
void scene_free(struct scene *scene);
//<
