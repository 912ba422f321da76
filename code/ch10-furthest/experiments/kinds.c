// Distances and nanoseconds a point of the furthest by cells and by the
// hull, of both answers at once, and of all pairs in tiles, on points
// that suit one of them and on points that suit none. One thread.
//     kinds [POINTS [TRIALS]]
#include "common/experiment.h"

static const struct {
    const char *algorithm, *name;
} ways[] = {{"furthest-cells", "cells"},
            {"furthest-hull", "hull"},
            {"near-and-far", "both"},
            {"tiles", "tiles"}};
static const char *const kinds[] = {
    "uniform", "clustered",    "lattice", "collinear",
    "kuzmin",  "two-clusters", "circle"};
enum { WAYS = COUNT_OF(ways) };

static void print_kind(const char *kind, uint32_t n, int trials)
{
    struct question question = kind_question(kind, n, 1);
    struct workspace workspace = {0};
    question.workspace = &workspace;
    struct answers *answers[WAYS];
    struct trial trial[WAYS];
    for (int k = 0; k < WAYS; k++) {
        const struct algorithm *algorithm =
            find_algorithm(ways[k].algorithm);
        answers[k] = new_answers(n, algorithm->answers);
        trial[k] = search_trial(algorithm->run, &question, answers[k]);
    }
    time_in_turn(trials, trial, WAYS);
    row_begin("%s\t%u", kind, n);
    for (int k = 0; k < WAYS; k++) {
        struct counts counts = count_operations(
            find_algorithm(ways[k].algorithm), &question, answers[k]);
        row_cells("\t%.5g", (double)counts.distances / n);
        row_times(&trial[k].summary, n);
    }
    row_end();
    workspace_free(&workspace);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 5000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    print_header(&e,
                 "name n cells_distances cells:3 hull_distances hull:3"
                 " both_distances both:3 tiles_distances tiles:3");
    for (int k = 0; k < COUNT_OF(kinds); k++)
        print_kind(kinds[k], n, trials);
}
