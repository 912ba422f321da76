// A library by others that finds nearest neighbors, behind four
// functions, so that all are used alike, and timed apart.
// The points are where the library likes them best, x beside y. A point
// is not its own neighbor; which of several that tie, is up to the
// library.
#pragma once
#include <stdint.h>

typedef double place[2];

enum { LEAVES = 4 };

struct peer {
    const char *name, *version;
    int leaf_size[LEAVES]; // sizes of a leaf to choose from
    int threaded;          // whether queries may run side by side

    // The structure over n points, which stay where they are.
    void *(*build)(const place *point, uint32_t n, int leaf_size,
                   int threads);
    // The nearest to each point, in the order of the points, and its
    // squared distance.
    void (*query)(void *built, int threads, uint32_t *nearest,
                  double *nearest2);
    void (*discard)(void *built);
};

#ifdef __cplusplus
extern "C" {
#endif
extern const struct peer peer_nanoflann, peer_cgal, peer_ann,
    peer_flann;
#ifdef __cplusplus
}
#endif
