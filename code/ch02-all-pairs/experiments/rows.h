// Times a rows_function on the first rows of a question, on one thread.
// Several trials may write into the same answers.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "common/experiment.h"

struct trial rows_trial(rows_function *function,
                        const struct question *question,
                        struct answers *answers, uint32_t rows);

// Uniform points in the box, or all in a quarter of it, where the
// direct way between two points is always the shorter one.
struct question question_in(bool quarter, enum geometry geometry,
                            uint32_t n);
