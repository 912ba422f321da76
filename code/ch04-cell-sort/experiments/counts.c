// For several numbers of points in a cell: cells visited and
// distances computed for each point, and the share of wrong neighbors
// if the search does not test; expected and counted, the last with
// wraparound, where there is no border.
//
//     counts [POINTS [SETS]]
#include "ch04-cell-sort/experiments/nine_cells.h"
#include "ch04-cell-sort/experiments/poisson.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/experiment.h"
#include <omp.h>
#include <stddef.h>

static const double per_cell[] = {0.25, 0.5, 1, 1.5, 2, 3, 4, 8};
static const char *const names[] = {
    "c_quarter", "c_half", "c_1", "c_1_5", "c_2", "c_3", "c_4", "c_8"};

struct sums {
    double cells[2], distances[2], wrong; // standard, wraparound
};

static void count_set(struct question *question, double c, int g,
                      struct answers *right, struct answers *found,
                      struct sums *sums)
{
    struct sorted sorted = sorted_make(question, c, cells_sort_alone);
    struct counts counts = {0};
    question->counts = &counts;
    search_sorted(question, &sorted, right);
    sums->cells[g] += counts.cells;
    sums->distances[g] += counts.distances;
    if (g == 1) {
        search_nine_cells(question, &sorted, found);
        for (uint32_t i = 0; i < question->points.n; i++)
            sums->wrong += right->nearest[i] != found->nearest[i];
    }
    sorted_free(&sorted);
}

static void print_row(uint32_t n, int sets, int k)
{
    struct answers right = answers_allocate(n);
    struct answers found = answers_allocate(n);
    struct sums sums = {0};
    for (int set = 0; set < sets; set++)
        for (int g = 0; g < 2; g++) {
            struct question question =
                uniform_question(g ? WRAPAROUND : STANDARD, n, set + 1);
            question.threads = omp_get_num_procs();
            count_set(&question, per_cell[k], g, &right, &found, &sums);
            points_free(&question.points);
        }
    double all = (double)n * sets, c = per_cell[k];
    row("%s\t%g\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g\t%.4g\t%.4g\t%.9g",
        names[k], c, expected_cells(c), sums.cells[0] / all,
        sums.cells[1] / all, expected_distances(c),
        sums.distances[0] / all, sums.distances[1] / all,
        expected_wrong(c), sums.wrong / all, all);
    answers_free(&right);
    answers_free(&found);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    int sets = parameter(&e, "SETS", 1, 1, MANY);
    columns(
        &e,
        "name c cells_expected cells cells_wrapped distances_expected "
        "distances distances_wrapped wrong_expected wrong points");
    for (size_t k = 0; k < sizeof per_cell / sizeof *per_cell; k++)
        print_row(n, sets, k);
    return 0;
}
