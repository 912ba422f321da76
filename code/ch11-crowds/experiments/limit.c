// Where pieces begin to pay: the same points in one grid and in pieces,
// the denser around a point, the longer the one grid takes. Every other
// point is in a square of side s in the middle of the unit square. That
// is 3/4 + 1/(4 s^2) times as dense around a point, on average, as even
// points are, which gives the side. Nanoseconds a point, and the
// density as counted.
//
//     limit [POINTS [TRIALS]]
#include "algorithms.h"
#include "ch04-cell-sort/sorted.h"
#include "ch09-row-spans/row_spans.h"
#include "ch11-crowds/by_sample.h"
#include "common/experiment.h"
#include <math.h>

static struct points with_core(uint32_t n, double side)
{
    struct random random = {1};
    struct points points = {n, take(n, sizeof(double)),
                            take(n, sizeof(double))};
    for (uint32_t i = 0; i < n; i++) {
        const double width = i % 2 ? side : 1;
        points.x[i] = 0.5 + width * (random_uniform(&random) - 0.5);
        points.y[i] = 0.5 + width * (random_uniform(&random) - 0.5);
    }
    return points;
}

static double density(const struct question *question)
{
    struct sorted sorted = sorted_make(question, POINTS_PER_SPAN_CELL);
    const double density =
        density_of_cells(&sorted, POINTS_PER_SPAN_CELL);
    sorted_free(&sorted);
    return density;
}

static void print_density(double wanted, uint32_t n, int trials)
{
    const double side = sqrt(0.25 / (wanted - 0.75));
    struct workspace workspace[2] = {0};
    struct question question = {
        with_core(n, side), {STANDARD, 1, 1}, 1};
    const double counted = density(&question);
    struct trial trial[2];
    static const char *const way[] = {"row-spans", "adaptive"};
    for (int k = 0; k < 2; k++) {
        question.workspace = &workspace[k];
        trial[k] = search_trial(find_algorithm(way[k])->run, &question,
                                new_answers(n, NEAREST));
    }
    time_in_turn(trials, trial, 2);
    row_of_times(trial, 2, n, "density_%g\t%u\t%.4g\t%.4g", wanted, n,
                 side, counted);
    for (int k = 0; k < 2; k++)
        workspace_free(&workspace[k]);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    print_header(&e, "name n side density grid:3 pieces:3");
    static const double wanted[] = {1, 2, 3, 4, 6, 8, 12, 16, 24, 32};
    for (int k = 0; k < COUNT_OF(wanted); k++)
        print_density(wanted[k], n, trials);
}
