// Points of every kind, cut into pieces, one kind after the other: what
// several experiments count things in.
#pragma once
#include "ch11-crowds/piece_batches.h"

// Points of a kind in their pieces, with room for all neighbors. The
// question is for one thread and counts nothing.
struct cut_kind {
    const char *name;
    struct question question;
    struct pieces pieces;
    struct neighbor *results;
};

typedef void look_function(const struct cut_kind *kind);

// Cuts n points of a kind, and lets a function look at them.
void cut_one_kind(const char *name, uint32_t n, look_function *look);

// The main of such an experiment: reads POINTS, heads the table, and
// does the same for every kind. Says how many points.
uint32_t cut_all_kinds(int argc, char **argv, const char *names,
                       look_function *look);
