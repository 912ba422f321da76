// Asks a structure about many boxes, and says what one costs. Shared by
// the experiments of this chapter.
#pragma once
#include "ch12-range-queries/structures.h"
#include "common/experiment.h"

enum { MAX_BOXES = 1000, MAX_TRIALS = 25 };

// Points, and boxes to ask about.
struct query_workload {
    struct point_set points;
    struct range all;
    uint32_t *found;
    struct range box[MAX_BOXES];
};

// n points of a kind in d dimensions, no boxes yet. All but the points
// belongs to the experiment.
struct query_workload *workload_of(const char *kind, uint32_t n, int d);
void workload_free(struct query_workload *workload);

// Boxes anywhere whose sides have this share of those of the range; or
// each around a point, reaching as far as its neighbor of a number.
void boxes_anywhere(struct query_workload *workload, double share);
void boxes_around_points(struct query_workload *workload,
                         uint32_t neighbors);

// A box, on average; times of several trials. Asks about as many of the
// boxes as there is time for.
struct cost {
    struct summary ns;
    double found, steps, tested;
};
struct cost ask_boxes(struct query_workload *workload,
                      const struct structure *structure,
                      const void *built, int trials);

// A structure with its leaves or cells at the size that is usual.
struct cost build_and_ask(struct query_workload *workload,
                          const struct structure *structure,
                          int trials);

// All of the boxes once, whatever it takes: the sums of their counts.
struct report ask_all(struct query_workload *workload,
                      const struct structure *structure);

// All points move by up to this, along each coordinate. Called
// again it moves each of them by the same as before: they keep their
// velocities.
void move_points(struct query_workload *workload, double max_step);
