// Programs of this book and of others find all nearest neighbors of the
// same points. The answers are compared, and building and querying are
// timed apart. A program that would take too long, judging by its times
// for fewer points, is not run.
#pragma once
#include "common/clock.h"
#include "common/question.h"
#include "peers/peer.h"
#include <stdbool.h>

struct program {
    const char *name;
    search_function *search; // of the book; or NULL, and then
    const struct peer *peer; // one of the others
};

// A problem: the points in both layouts, and the squared distances to
// their neighbors, once a program has found them.
struct instance {
    struct points points;
    place *place;
    double *right2;
    bool known;
};

// Takes the points over. Released with instance_free.
struct instance instance_of(struct points points);
void instance_free(struct instance *instance);

enum { MAX_TRIALS = 100 };

// A point that takes ten times what is usual is not worth the wait.
enum { MAX_NS_A_POINT = 25000 };

struct rules {
    double limit;    // ns a point: what needs more is not run
    double patience; // ns for the trials of a program, but at least one
    int trials;      // at most, and at most MAX_TRIALS
    int threads;     // all of them
};

// What a program took for 10 and for 100 times fewer points, in ns; all
// zero where there were none.
struct history {
    double last, before;
};

struct times {
    struct summary build, query, total; // ns
};

// One trial is a try; only programs that get more of them also run with
// all threads.
struct result {
    double expected;       // ns, judging by the history; 0: unknown
    int trials;            // 0: not run, and the rest is not set
    bool threaded;         // whether all is set
    struct times one, all; // with one thread, with all
    uint32_t differ;       // answers not the same to the last bit
};

// The size of a leaf that makes a peer fastest on this instance.
int best_leaf_size(const struct peer *peer,
                   const struct instance *instance,
                   struct answers *answers);

// Ends the program if an answer is wrong by more than rounding. The
// program that comes first says what is right; the answers are
// overwritten.
struct result compete(const struct program *program, int leaf_size,
                      const struct rules *rules,
                      struct instance *instance,
                      struct answers *answers, struct history *history);
