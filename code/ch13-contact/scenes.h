//> Declare the built-in scenes
// Scenes to try things on, by name. Coordinates and times have no
// units; the largest bodies are some 2 across.
#pragma once
#include "ch13-contact/scene.h"

//> Describe a built-in scene
struct built_in {
    const char *name;  // as in contact --scene NAME
    const char *about; // one line for contact --list
    uint32_t usual;    // its size, if none is asked for
    uint32_t min_size, max_size;
    double dt; // of a step
    // Adds its bodies to an empty scene. The same size and seed give
    // the same scene.
    void (*fill)(struct scene *scene, uint32_t size, uint64_t seed);
};
//<

extern const struct built_in built_ins[];
extern const int built_in_count;

// NULL if there is no such scene.
const struct built_in *find_built_in(const char *name);

// Complete; released with scene_free.
struct scene build_scene(const struct built_in *built_in, uint32_t size,
                         uint64_t seed);

// n bodies of some 80 triangles in random motion, so close that many
// nearly touch, without gravity: at this speed a body goes so far in a
// time of 1, at most.
void fill_cloud(struct scene *scene, uint32_t n, double speed,
                uint64_t seed);
//<
