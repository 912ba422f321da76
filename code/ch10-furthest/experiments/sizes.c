// The whole time a point of the furthest by cells, by the hull and by
// regions, of both answers in one go, and of the nearest by row spans,
// on one thread, from a thousand points on: in the standard geometry
// and, for those who know it, with wraparound.
//
//     sizes [MOST]
#include "algorithms.h"
#include "common/experiment.h"
#include "common/workspace.h"

static const struct {
    const char *algorithm, *name;
    enum geometry geometry;
    unsigned answers;
} curves[] = {
    {"row-spans", "spans", STANDARD, NEAREST},
    {"furthest-cells", "cells", STANDARD, FURTHEST},
    {"furthest-hull", "hull", STANDARD, FURTHEST},
    {"near-and-far", "far", STANDARD, FURTHEST},
    {"near-and-far", "both", STANDARD, NEAREST | FURTHEST},
    {"row-spans", "spans_wrapped", WRAPAROUND, NEAREST},
    {"furthest-cells", "cells_wrapped", WRAPAROUND, FURTHEST},
    {"near-and-far", "both_wrapped", WRAPAROUND, NEAREST | FURTHEST}};
enum { CURVES = sizeof curves / sizeof *curves, SEVERAL = 1000000 };

static void print_points(uint32_t n)
{
    struct question question = uniform_question(STANDARD, n, 1);
    struct workspace workspace = {0};
    question.workspace = &workspace;
    struct answers answers[CURVES];
    struct search search[CURVES];
    struct trial trial[CURVES];
    for (int k = 0; k < CURVES; k++) {
        const struct algorithm *algorithm =
            find_algorithm(curves[k].algorithm);
        answers[k] = answers_for(n, curves[k].answers);
        question.space.geometry = curves[k].geometry;
        search[k] =
            (struct search){algorithm->run, question, &answers[k]};
        trial[k] = (struct trial){.work = run_search,
                                  .prepare = run_search,
                                  .context = &search[k]};
    }
    time_in_turn(n > SEVERAL ? 1 : 5, trial, CURVES);
    row_begin("n%u\t%u", n, n);
    for (int k = 0; k < CURVES; k++) {
        row_times(&trial[k].summary, n);
        answers_free(&answers[k]);
    }
    row_end();
    workspace_free(&workspace);
    points_free(&question.points);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 300000, 1000, MANY);
    columns(&e, "name n spans:3 cells:3 hull:3 far:3 both:3"
                " spans_wrapped:3 cells_wrapped:3 both_wrapped:3");
    for (uint64_t n = 1000; n <= most; n *= 10)
        for (int third = 0; third < 2; third++)
            if ((third ? 3 * n : n) <= most)
                print_points(third ? 3 * n : n);
    return 0;
}
