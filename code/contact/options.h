// The command line of contact, checked.
#pragma once
#include "ch13-contact/broad_phase.h"
#include "ch13-contact/scenes.h"

struct options {
    const char *file; // of a scene, "-": standard input; or NULL
    const struct built_in *built_in; // if there is no file
    uint32_t size;                   // of it; 0: as usual
    uint64_t seed;
    uint32_t steps;
    double dt;        // 0: as the scene says
    double tolerance; // 0: as usual
    const struct broad_phase *broad;
    int threads;          // 0: as many as are worth it
    const char *output;   // file for the table, "-": standard output
    const char *pictures; // folder for them; or NULL
    int events;           // the table has a row for each event
    int passive, check, list, help;
};

// Fails with a sentence on anything it does not understand.
struct options parse_contact_options(int argc, char **argv);
