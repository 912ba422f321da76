//> Declare the motion
// From the places at the time t to those at t + dt. Between the two a
// node moves along a straight line. Each function costs time in
// proportion to the nodes.
#pragma once
#include "ch13-contact/scene.h"

// Gravity acts for a time dt on what is not fixed.
void scene_accelerate(struct scene *scene, double dt);

//> Hold a pose
struct pose {
    double position[3], orientation[4];
};
//<

// Where a body is after a time dt at its two velocities.
struct pose pose_after(const struct body *body, double dt);

// Where the nodes of a body are in a pose: to[k][i] for node i. Fails
// where they are too far away for exact tests.
void place_nodes(const struct scene *scene, const struct body *body,
                 const struct pose *pose, double *const to[3]);

// predicted[] is where all nodes are after a time dt; nothing else
// changes.
void scene_predict(struct scene *scene, double dt, int threads);
//<
