// The command line of near, checked. After parsing, every option has a
// value that makes sense by itself.
#pragma once
#include "algorithms.h"
#include "common/generate.h"
#include "common/read_points.h"
#include <stdbool.h>

struct options {
    const char *file; // to read, "-": standard input; or NULL
    struct columns columns;
    uint32_t n; // points to generate if there is no file
    const struct distribution *distribution;
    uint64_t seed;
    bool random;                       // one of the last three was said
    const struct algorithm *algorithm; // NULL: the fastest
    enum geometry geometry;
    bool has_box;
    double box[4];       // x0, y0, x1, y1, if it has one
    int threads, trials; // threads: 0: as many as are worth it
    const char *output;  // file for the answers, "-": standard output
    uint32_t k;          // so many nearest neighbors; 0: not asked
    bool within;         // all within a distance
    double distance;
    int counts; // only how many
    int timing, check, list, help;
};

// Fails with a sentence on anything it does not understand.
struct options parse_options(int argc, char **argv);
