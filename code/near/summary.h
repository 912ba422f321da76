// What near says when it is done: a warning, if squares of distances
// left the range of a double, what a check has found, and a summary or
// a table of times.
#pragma once
#include "common/question.h"
#include "near/check.h"
#include "near/options.h"
#include <stdbool.h>

// Prints a warning where squared distances leave the range of a double.
void warn_of_range(const struct question *question,
                   const struct answers *answers);

// Prints how many points there are, in which geometry, and the mean of
// each kind of distance that was asked for.
void print_summary(const struct options *options,
                   const struct question *question,
                   const struct answers *answers);

// Whether the closest images of two points are in different places.
bool are_apart(const struct question *question, uint32_t i, uint32_t j);

// The warning, if squares left the range above or below.
void warn_of_squares(bool overflow, bool underflow);

// Says how many of n answers, which have this name, are wrong: on
// standard output, unless a table is written there. Returns whether all
// are right.
bool report_check(const struct options *options, const char *what,
                  struct verdict verdict, uint32_t n);

// The table of --timing: its first line, and a line for each trial.
void print_times_header(void);
void print_times(const struct question *question,
                 const char *algorithm_name, double build_ns,
                 double query_ns, uint64_t distances);

// The line of a summary with the time.
void print_time(const char *algorithm_name, double ns, int threads);
