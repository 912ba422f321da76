//> Declare the scene
// Bodies and how they move. A rigid body is where its middle is, and
// turned by its orientation; of a soft one, each node moves on its own;
// a fixed one stays, and so does one that sleeps, a rigid one that has
// come to rest (sleep.h).
#pragma once
#include "ch13-contact/mesh.h"
#include <stdbool.h>

//> Hold a body
enum motion { FIXED, RIGID, SOFT, ASLEEP };

struct body {
    enum motion motion;
    struct mesh_mark begin, end; // its nodes and triangles
    double position[3];          // of its middle
    double orientation[4];       // a quaternion of length 1, real first
    double velocity[3], angular_velocity[3];
    double inverse_mass;    // 1 / mass: how easily it is moved
    double inverse_inertia; // 1 / moment of inertia: how easily turned
};

// Whether it stays, whatever comes.
static inline bool is_held(const struct body *body)
{
    return body->motion == FIXED || body->motion == ASLEEP;
}
//<

//> Hold a scene
struct scene {
    struct mesh mesh;     // the nodes' places at the time t
    double *predicted[3]; // their places at t + dt
    double *local[3];     // in the frame of the body: from its middle,
                          // before it is turned
    double *velocity[3];  // of the nodes of soft bodies
    uint32_t *body_of;    // of each triangle
    uint32_t *body_of_node;
    uint32_t *group; // of each triangle: see scene_complete
    struct body *body;
    uint32_t bodies, room;
    double gravity[3];
};
//<

//> Say how a body begins
// {RIGID}: at rest at the origin, not turned, as large as its shape.
struct initial_state {
    enum motion motion;
    double size; // its shape is made so much larger
    double position[3], velocity[3], angular_velocity[3];
};
//<

// Makes a body of what the scene's mesh has got since, around the
// origin: it is made larger, and then moved to its place. A rigid body
// is as heavy as the box around it and turns about the mean of its
// nodes; that it turns as easily in all directions, as a ball does, is
// a simplification.
void scene_add(struct scene *scene, struct mesh_mark since,
               const struct initial_state *initial);

// To be called once, when all bodies are there: makes room for what
// moves. Two triangles of the same group cannot touch: those of a rigid
// body are one, those of all fixed bodies are one; a triangle of a soft
// body is in no group, NO_INDEX.
void scene_complete(struct scene *scene);
void scene_free(struct scene *scene);
//<
