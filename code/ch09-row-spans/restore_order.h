//> Declare how order is restored
// Queries run in the order of the cells, and their answers are wanted
// in the order of the input. So answers go back the way that points
// came: first to where the point's record was, which is in the same
// bucket, and so in a cache; then, read in the order of the input, from
// as many streams as there are buckets.
#pragma once
#include "common/question.h"

//> Hold an answer on its way
struct neighbor {
    double distance2;
    uint32_t index; // of the neighbor
};
//<

// Of n points; permutation[i] says in which result point i has its
// neighbor. By so many threads.
void restore_order(const struct neighbor *results,
                   const uint32_t *permutation, uint32_t n, int threads,
                   uint32_t *index, double *distance2);
//<
