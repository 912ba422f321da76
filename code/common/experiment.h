// An experiment measures something and prints a table: where the
// numbers come from, in lines that begin with #; the names of the
// columns; and rows, each of which begins with its name, a word that
// prose can quote. What is left for its main is what it measures:
//
//     int main(int argc, char **argv)
//     {
//         struct experiment e = experiment_begin(argc, argv);
//         uint32_t n = parameter(&e, "POINTS", 8192, 2, MANY);
//         int trials = parameter(&e, "TRIALS", 5, 1, MANY);
//         struct question question = uniform_question(STANDARD, n, 1);
//         struct answers *answers = new_answers(n, BOTH);
//         struct trial versions[] = {
//             search_trial(naive, &question, answers),
//             search_trial(tiles, &question, answers)};
//         time_in_turn(trials, versions, 2);
//         print_header(&e, "name n naive_ns:3 tiles_ns:3");
//         row_of_times(versions, 2, n, "points_%u\t%u", n, n);
//     }
//
// The driver owns the memory of questions, answers and trials. What
// main itself still holds when it returns, the system takes back.
#pragma once
#include "algorithms.h"
#include "common/clock.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/isa.h"
#include "common/random.h"
#include "common/workspace.h"
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// More points, rows or trials than anybody waits for, and few enough
// for an int.
enum { MANY = 1000000000 };

#define COUNT_OF(array) ((int)(sizeof(array) / sizeof *(array)))

struct experiment {
    int argc, next; // the argument to be read next
    char **argv;
};

// Called first: from then on messages begin with the program's name,
// and output that cannot be written ends the program.
struct experiment experiment_begin(int argc, char **argv);

// The next argument, a whole number from min to max; 2e4 is one, too.
// If there is none, the usual number, or max if that is less.
// Fails with the name of the parameter, what was expected and found.
uint32_t parameter(struct experiment *experiment, const char *name,
                   uint32_t usual, uint32_t min, uint32_t max);

// Heads the table: machine, compiler, flags and date, and the names of
// the columns, with a space between two. NAME:3 stands for three,
// median and quartiles: NAME, NAME_q1 and NAME_q3; NAME:5 for NAME_min
// and NAME_max as well. Fails if there are more arguments than
// parameters.
void print_header(const struct experiment *experiment,
                  const char *names);

// Prints a row, or its beginning; tabs between the cells are the
// caller's. In its first word, - becomes _: two-clusters is
// two_clusters, which prose can quote.
void row(const char *format, ...) __attribute__((format(printf, 1, 2)));
void row_begin(const char *format, ...)
    __attribute__((format(printf, 1, 2)));

// Goes on with more cells; with those of a column NAME:3, divided by a
// number; with those of a column NAME:5. Ends the row, which is written
// at once.
void row_cells(const char *format, ...)
    __attribute__((format(printf, 1, 2)));
void row_times(const struct summary *summary, double divisor);
void row_spread(const struct summary *summary);
void row_end(void);

// Prints a row: its beginning, and the times of count trials, each
// divided by the same number.
void row_of_times(const struct trial *trials, int count, double divisor,
                  const char *format, ...)
    __attribute__((format(printf, 4, 5)));

// Memory for count elements of size bytes, cleared. The driver keeps
// it, with all that is declared below, until forget gives it up, before
// the next of several rows, or until the program ends.
void *take(size_t count, size_t size);
void forget(void);

// A question about n points of a kind that generate knows, or about
// uniform points, for one thread; the standard geometry, if no other is
// given.
struct question kind_question(const char *kind, uint32_t n,
                              uint64_t seed);
struct question uniform_question(enum geometry geometry, uint32_t n,
                                 uint64_t seed);

// Room for these answers, a set of enum answer; the others are NULL.
enum { BOTH = NEAREST | FURTHEST };
struct answers *new_answers(uint32_t n, unsigned given);

// A whole search, to be timed, of the question as it is now.
struct trial search_trial(search_function *search,
                          const struct question *question,
                          struct answers *answers);

// The next of the numbers of points 1000, 3000, 10000, 30000, ...
uint32_t next_size(uint32_t n);
