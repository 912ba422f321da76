//> Declare the tally of a search
// What passes through the three loops, counted: for tests, and for the
// bill of experiments.
#pragma once
#include <stdint.h>

//> Tally what passes through the loops
enum { LAYERS_TALLIED = 8, LANES_TALLIED = 8 };

struct tally {
    uint64_t tasks;
    uint64_t phase_one[LAYERS_TALLIED]; // tasks at layer k
    uint64_t phase_two[LAYERS_TALLIED];
    uint64_t of_layer[LAYERS_TALLIED]; // cells of it that are visited
    uint64_t listed;         // tasks, before their list is packed
    uint64_t bound_steps;    // tried to find the search bounds
    uint64_t tried;          // tasks of a list, at each step of it
    uint64_t visited;        // cells within the bounds
    uint64_t entered;        // of these, with points
    uint64_t compared;       // points
    uint64_t cell_steps;     // times that the loop over cells ran
    uint64_t point_steps;    // and the one over points
    uint64_t lanes;          // taken by it, in vectors of eight
    uint64_t lanes_unpacked; // if nothing were ever packed
};
//<

// Adds every count of the second to the first.
void tally_add(struct tally *sum, const struct tally *tally);
//<
