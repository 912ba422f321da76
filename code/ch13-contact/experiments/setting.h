// Scenes for the experiments of this chapter.
#pragma once
#include "ch13-contact/scenes.h"
#include "ch13-contact/step.h"
#include "common/experiment.h"

enum {
    MAX_TRIALS = 25,
    TRIANGLES_PER_BODY = 69 // on average
};

// A cloud of about so many triangles, at least, after some steps in
// which bodies pass through each other; from then on they are apart no
// more, and contacts are only found. With giant, beside a body of 20
// large triangles. Released with simulation_free.
struct simulation cloud_of(uint32_t triangles, bool giant,
                           const struct broad_phase *phase, double dt);

// Predicts the next step, captures, and finds the pairs; says how long
// the pairs took. Nothing is advanced.
double time_broad(struct simulation *s);

// Where the nodes are predicted to be, there they are. Bodies that
// leave the space in which they began turn round.
void go_on(struct simulation *s);
