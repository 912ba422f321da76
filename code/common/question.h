//> State the question and its answers
// What every algorithm of the book is asked, and where it answers.
#pragma once
#include "common/count.h"
#include "common/geometry.h"
#include "common/points.h"

struct workspace;

struct question {
    struct points points;  // n >= 2, all coordinates finite
    struct space space;    // wraparound: the box holds all points
    int threads;           // >= 1
    struct counts *counts; // what is done is added; NULL: not wanted
    struct workspace *workspace; // the caller's; NULL: a temporary one
};

// Arrays of n, owned by the caller; those of an answer that the
// algorithm does not give may be NULL. A point is never its own
// neighbor; a duplicate, at distance 0, is. Ties go to the lowest
// index, so that every run gives the same answer.
struct answers {
    uint32_t *nearest, *furthest; // index of the neighbor
    double *nearest2, *furthest2; // squared distance to it
    int64_t built_ns;             // clock_ns() once built; or untouched
};

// What answers a question.
typedef void search_function(const struct question *question,
                             struct answers *answers);

// Room for all four answers of n points, not yet set.
struct answers answers_allocate(uint32_t n);
void answers_free(struct answers *answers);
//<
