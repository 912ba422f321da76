// The searches of this chapter by name, each on a structure that was
// made before: lists, lists_in_order, indices, indices_in_order,
// sorted, batches. "In order" are the queries, by cell.
#pragma once
#include "ch04-cell-sort/lists.h"
#include "ch04-cell-sort/sorted.h"
#include "common/experiment.h"

struct bench {
    struct question question;
    struct sorted sorted;
    struct lists lists;
    struct answers *answers;
};

// With c points in a cell. It lasts until the program ends.
struct bench bench_make(struct question question, double c);

// A search of this name; fails if there is none.
struct trial bench_trial(struct bench *bench, const char *name);
