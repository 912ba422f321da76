//> State the question and its answers
// What every algorithm of the book is asked, and where it answers.
#pragma once
#include "common/count.h"
#include "common/geometry.h"
#include "common/points.h"

struct workspace;
struct extent;

//> Put a question
struct question {
    struct points points;  // n >= 2, all coordinates finite
    struct space space;    // wraparound: the box holds all points
    int threads;           // >= 1
    struct counts *counts; // what is done is added; NULL: not wanted
    struct workspace *workspace; // the caller's; NULL: a temporary one
    int64_t *built_ns; // when what is searched was built; or NULL
    const char **algorithm_name; // set if a row chose one; or NULL
    const struct extent *box;    // of x and of y, if known; or NULL
};
//<

// Notes the time: what is searched has been built.
void note_built(const struct question *question);

//> Hold the answers
// Arrays of n, owned by the caller; those of an answer that the
// algorithm does not give may be NULL. A point is never its own
// neighbor; a duplicate, at distance 0, is. Ties go to the lowest
// index, so that every run gives the same answer.
struct answers {
    uint32_t *nearest, *furthest; // index of the neighbor
    double *nearest2, *furthest2; // squared distance to it
};
//<

// What answers a question.
typedef void search_function(const struct question *question,
                             struct answers *answers);

// Runs a search that needs a workspace, even if the question has none:
// then the search gets a copy of the question that has a temporary one.
// What the search takes from the workspace is given back at its end.
void search_in_workspace(const struct question *question,
                         search_function *search,
                         struct answers *answers);

enum answer { NEAREST = 1, FURTHEST = 2 }; // bits of a set

// Room for the answers given, a set of enum answer; the arrays of the
// others are NULL. Released with answers_free.
struct answers answers_for(uint32_t n, unsigned given);
struct answers answers_allocate(uint32_t n); // room for all four
void answers_free(struct answers *answers);
//<
