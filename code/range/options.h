// The command line of range, checked.
#pragma once
#include "ch12-range-queries/structures.h"
#include "common/generate.h"

enum range_question { BOXES = 1, WITHIN, NEAREST_K };

struct options {
    const char *file; // to read, "-": standard input; or NULL
    uint32_t n;       // points to generate if there is no file
    int dimensions;
    const struct distribution *distribution;
    uint64_t seed;
    enum range_question question;
    double distance;     // within it
    uint32_t k;          // so many nearest
    const char *queries; // a file; or NULL
    uint32_t random;     // so many random queries; or 0
    double share;        // of a random box's sides
    const struct structure *structure;
    int threads, trials; // threads: 0: as many as are worth it
    const char *output;  // file for the answers, "-": standard output
    int counts, timing, check, list, help;
};

// Fails with a sentence on anything it does not understand.
struct options parse_range_options(int argc, char **argv);
