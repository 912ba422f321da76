// The search for all points of the plane, as the program near makes it
// for -k and --within, among the others.
#pragma once
#include "peers/range_scene.h"

// Of all: to build, the nearest ones of each point into the scene's
// arrays, all within the distance, each in a list. Says how many these
// are, each point itself included. Two dimensions.
struct plane_times {
    double build, nearest, within; // ns
};
uint64_t answer_in_plane(struct range_scene *scene,
                         struct plane_times *times);
