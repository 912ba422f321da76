// For several numbers of points in a cell: cells visited and
// distances computed for each point, and the share of wrong neighbors
// if the search does not test; expected and counted, the last with
// wraparound, where there is no border.
//     counts [POINTS [SETS]]
#include "ch04-cell-sort/experiments/nine_cells.h"
#include "ch04-cell-sort/experiments/poisson.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/experiment.h"

static const struct {
    const char *name;
    double c;
} sizes[] = {{"c_quarter", 0.25}, {"c_half", 0.5}, {"c_1", 1},
             {"c_1_5", 1.5},      {"c_2", 2},      {"c_3", 3},
             {"c_4", 4},          {"c_8", 8}};

// Of all points of several sets.
struct sums {
    struct counts counts;
    double wrong; // if the search stops at nine cells
};

static struct sums add_up(enum geometry geometry, uint32_t n, int sets,
                          double c)
{
    struct sums sums = {0};
    for (int set = 1; set <= sets; set++) {
        struct question question = uniform_question(geometry, n, set);
        question.threads = omp_get_num_procs();
        question.counts = &sums.counts;
        struct sorted sorted = sorted_make(&question, c);
        struct answers *right = new_answers(n, NEAREST);
        struct answers *found = new_answers(n, NEAREST);
        search_sorted(&question, &sorted, right);
        question.counts = NULL;
        search_nine_cells(&question, &sorted, found);
        for (uint32_t i = 0; i < n; i++)
            sums.wrong += right->nearest[i] != found->nearest[i];
        sorted_free(&sorted);
        forget();
    }
    return sums;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    int sets = parameter(&e, "SETS", 1, 1, MANY);
    print_header(
        &e,
        "name c cells_expected cells cells_wrapped distances_expected "
        "distances distances_wrapped wrong_expected wrong points");
    for (int k = 0; k < COUNT_OF(sizes); k++) {
        const double c = sizes[k].c, all = (double)n * sets;
        struct sums bounded = add_up(STANDARD, n, sets, c);
        struct sums wrapped = add_up(WRAPAROUND, n, sets, c);
        row("%s\t%g\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g\t%.4g\t%.4g"
            "\t%.9g",
            sizes[k].name, c, expected_cells(c),
            bounded.counts.cells / all, wrapped.counts.cells / all,
            expected_distances(c), bounded.counts.distances / all,
            wrapped.counts.distances / all, expected_wrong(c),
            wrapped.wrong / all, all);
    }
}
