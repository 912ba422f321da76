//> Try the furthest on points of every kind
// Distances and nanoseconds a point of the furthest by cells and by the
// hull, of both answers at once, and of all pairs in tiles, on points
// that suit one of them and on points that suit none. One thread.
//
//     kinds [POINTS [TRIALS]]
#include "algorithms.h"
#include "ch02-all-pairs/timing.h"
#include "ch09-row-spans/keep.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"

static const struct {
    const char *algorithm, *name;
} ways[] = {{"furthest-cells", "cells"},
            {"furthest-hull", "hull"},
            {"near-and-far", "both"},
            {"tiles", "tiles"}};
static const char *const kinds[] = {
    "uniform", "clustered",    "lattice", "collinear",
    "kuzmin",  "two-clusters", "circle"};
enum {
    WAYS = sizeof ways / sizeof *ways,
    KINDS = sizeof kinds / sizeof *kinds
};

//> Time and count one kind
static void print_kind(const char *kind, uint32_t n, int trials)
{
    struct question question = kind_question(kind, n, 1);
    struct answers answers[WAYS];
    struct search search[WAYS];
    struct trial trial[WAYS];
    for (int k = 0; k < WAYS; k++) {
        const struct algorithm *algorithm =
            find_algorithm(ways[k].algorithm);
        answers[k] = answers_for(n, algorithm->answers);
        search[k] =
            (struct search){algorithm->run, question, &answers[k]};
        trial[k] =
            (struct trial){.work = run_search, .context = &search[k]};
    }
    time_in_turn(trials, trial, WAYS);
    print_word(stdout, kind);
    printf("\t%u", n);
    for (int k = 0; k < WAYS; k++) {
        struct counts counts = count_operations(
            find_algorithm(ways[k].algorithm), &question, &answers[k]);
        printf("\t%.5g", (double)counts.distances / n);
        print_summary(&trial[k].summary, n);
        answers_free(&answers[k]);
    }
    puts("");
    fflush(stdout);
    points_free(&question.points);
}
//<

int main(int argc, char **argv)
{
    fail_as("kinds");
    memory_keep();
    uint32_t n = argument(argc, argv, 1, "POINTS", 5000, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    report_provenance(stdout);
    printf("name\tn");
    for (int k = 0; k < WAYS; k++) {
        printf("\t%s_distances", ways[k].name);
        print_summary_columns(ways[k].name);
    }
    puts("");
    for (int k = 0; k < KINDS; k++)
        print_kind(kinds[k], n, trials);
    return 0;
}
//<
