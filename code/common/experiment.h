//> Declare the driver of experiments
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
//         struct answers answers = answers_allocate(n);
//         struct search plain = {naive, question, &answers};
//         struct search fast = {tiles, question, &answers};
//         struct trial versions[] = {{run_search, &plain},
//                                    {run_search, &fast}};
//         time_in_turn(trials, versions, 2);
//         columns(&e, "name n naive_ns:3 tiles_ns:3");
//         row_of_times(versions, 2, n, "points_%u\t%u", n, n);
//         answers_free(&answers);
//         points_free(&question.points);
//         return 0;
//     }
#pragma once
#include "common/clock.h"
#include "common/question.h"

// More points, rows or trials than anybody waits for, and few enough
// for an int.
enum { MANY = 1000000000 };

struct experiment {
    int argc, next; // the argument to be read next
    char **argv;
};

// Called first: from then on messages begin with the program's name,
// and output that cannot be written ends the program.
struct experiment experiment_begin(int argc, char **argv);

// The next argument, a whole number from least to most; 2e4 is one,
// too. If there is none, the number otherwise, or most if that is less.
// Fails with the name of the parameter, what was expected and found.
uint32_t parameter(struct experiment *experiment, const char *name,
                   uint32_t otherwise, uint32_t least, uint32_t most);

// Heads the table: machine, compiler, flags and date, and the names of
// the columns, with a space between two. NAME:3 stands for three,
// median and quartiles: NAME, NAME_q1 and NAME_q3; NAME:5 for NAME_min
// and NAME_max as well. Fails if there are more arguments than
// parameters.
void columns(const struct experiment *experiment, const char *names);

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

// A question about n points of a kind that generate knows, or about
// uniform points, for one thread; the standard geometry, if no other is
// given. Its points are released with points_free.
struct question kind_question(const char *kind, uint32_t n,
                              uint64_t seed);
struct question uniform_question(enum geometry geometry, uint32_t n,
                                 uint64_t seed);

// A whole search, to be timed: the context of run_search is a struct
// search.
struct search {
    search_function *search;
    struct question question;
    struct answers *answers;
};
void run_search(void *context);
//<
