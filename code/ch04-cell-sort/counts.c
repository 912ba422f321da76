//> Count what the blocks cost, and where they err
// For several numbers of points in a cell: cells looked at and
// distances computed for each point, and the share of wrong neighbors
// if the search does not test; expected and counted, the last with
// wraparound, where there is no border.
//
//     counts [POINTS [SETS]]
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/point_by_point.h"
#include "ch04-cell-sort/poisson.h"
#include "common/argument.h"
#include "common/count.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>
#include <stdio.h>

static const double per_cell[] = {0.25, 0.5, 1, 1.5, 2, 3, 4, 8};
static const char *const names[] = {
    "c_quarter", "c_half", "c_1", "c_1_5", "c_2", "c_3", "c_4", "c_8"};

struct sums {
    double cells[2], distances[2], wrong; // standard, wraparound
};

//> Count in one set of points
static void count_set(const struct question *question, double c, int g,
                      struct answers *right, struct answers *found,
                      struct sums *sums)
{
    struct sorted sorted = sorted_make(question, c, cells_sort_alone);
    counting_take();
    counting_search_sorted(question, &sorted, right);
    struct counts counts = counting_take();
    sums->cells[g] += counts.cells;
    sums->distances[g] += counts.distances;
    if (g == 1) {
        search_untested(question, &sorted, found);
        for (uint32_t i = 0; i < question->points.n; i++)
            sums->wrong += right->nearest[i] != found->nearest[i];
    }
    sorted_free(&sorted);
}
//<

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
    printf(
        "%s\t%g\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g\t%.4g\t%.4g\t%.9g"
        "\n",
        names[k], c, expected_cells(c), sums.cells[0] / all,
        sums.cells[1] / all, expected_distances(c),
        sums.distances[0] / all, sums.distances[1] / all,
        expected_wrong(c), sums.wrong / all, all);
    fflush(stdout);
    answers_free(&right);
    answers_free(&found);
}

int main(int argc, char **argv)
{
    fail_as("counts");
    uint32_t n = argument(argc, argv, 1, "POINTS", 100000, 2, MANY);
    int sets = argument(argc, argv, 2, "SETS", 1, 1, MANY);
    report_provenance(stdout);
    puts("name\tc\tcells_expected\tcells\tcells_wrapped"
         "\tdistances_expected\tdistances\tdistances_wrapped"
         "\twrong_expected\twrong\tpoints");
    for (size_t k = 0; k < sizeof per_cell / sizeof *per_cell; k++)
        print_row(n, sets, k);
    return 0;
}
//<
