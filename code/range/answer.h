// Answers queries, a batch at a time, and keeps what they find.
#pragma once
#include "range/input.h"

struct task {
    const struct options *options;
    struct point_set points;
    struct queries queries;
    const struct structure *structure;
    const void *built;
    int threads;
};

// The answer to one query, in its final order: boxes by index, the
// others by distance.
struct answer {
    uint32_t count;
    uint32_t *point;
    double *distance2; // NULL for boxes
};

// What all queries of a run found and cost.
struct totals {
    uint64_t found, steps, tested;
};

enum { BATCH = 1024 };

// Answers queries first to last - 1, at most a batch, and adds to the
// totals. With keep, answer[0 ..] are filled, and released with
// answers_release.
void answer_batch(const struct task *task, uint32_t first,
                  uint32_t last, struct answer *answer,
                  struct totals *totals);
void answers_release(struct answer *answer, uint32_t count);

// Query q as the structure wants it.
void place_of_query(const struct task *task, uint32_t q,
                    double place[MAX_DIMENSIONS]);
struct range range_of_query(const struct task *task, uint32_t q);
uint32_t self_of_query(const struct task *task, uint32_t q);
