//> Declare the private answers
// The triangular loop on several threads, each with answers of its own
// that are merged at the end: n (n-1) / 2 distances, nothing guarded,
// 24 bytes a point for every thread but the first.
#pragma once
#include "common/question.h"
#include <omp.h>

// The rows are handed out as schedule and chunk say (0: OpenMP's
// default chunk); the answers are the same with any.
void triangle_private(const struct question *question,
                      struct answers *answers, omp_sched_t schedule,
                      int chunk);

// With the schedule that the book settles on: dynamic, 32 rows a time.
search_function triangle_reduction;
//<
