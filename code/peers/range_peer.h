// A library by others that answers questions about ranges in two or
// three dimensions, behind a few functions, so that all are used alike.
// Points are rows of d numbers.
#pragma once
#include <stdint.h>

struct range_peer {
    const char *name;
    // The structure over n points, which stay where they are.
    void *(*build)(const double *point, uint32_t n, int d);
    // The k nearest of each point but itself, and their squared
    // distances: those of point i from nearest[i k] on.
    void (*nearest)(void *built, uint32_t k, uint32_t *nearest,
                    double *nearest2);
    // How many points are within a distance of each, itself included,
    // all together; each is put into a list.
    uint64_t (*within)(void *built, double distance);
    // How many are in boxes, all together; each is put into a list. A
    // box is a row of d lows and d highs. NULL if it has no boxes.
    uint64_t (*boxes)(void *built, const double *box, uint32_t count);
    void (*discard)(void *built);
};

#ifdef __cplusplus
extern "C" {
#endif
extern const struct range_peer range_nanoflann, range_boost, range_cgal;
#ifdef __cplusplus
}
#endif
