//> Declare the generators
// Point sets to try things on. The same name, n and seed give the same
// points on every machine.
#pragma once
#include "common/points.h"

struct distribution {
    const char *name;  // as in near -d NAME
    const char *about; // one line for near --list
    void (*fill)(struct points points, uint64_t seed);
};

extern const struct distribution distributions[];
extern const int distribution_count;

// NULL if there is no such distribution.
const struct distribution *find_distribution(const char *name);

// n points; the caller releases them with points_free.
struct points generate(const struct distribution *distribution,
                       uint32_t n, uint64_t seed);
//<
