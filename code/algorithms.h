//> Declare the table of algorithms
// An algorithm is a row in one table. Whatever is in it is listed by
// `near --list`, faces every test of the corpus, and can be named in
// an experiment.
#pragma once
#include "common/question.h"

//> Describe an algorithm
struct algorithm {
    const char *name;    // as in near -a NAME
    int chapter;         // where the book builds it
    unsigned geometries; // set of enum geometry
    unsigned answers;    // set of enum answer
    const char *cost;    // of all n answers
    const char *about;   // one line
    search_function *run;
};
//<

extern const struct algorithm algorithms[];
extern const int algorithm_count;

// NULL if there is no such row.
const struct algorithm *find_algorithm(const char *name);

// The row to take where none is asked for; NULL if none fits.
const struct algorithm *fastest_algorithm(enum geometry geometry,
                                          enum answer answer);

// Runs the algorithm once and returns what it counted.
struct counts count_operations(const struct algorithm *algorithm,
                               const struct question *question,
                               struct answers *answers);
//<
