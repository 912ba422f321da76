//> Count who is packed away where
// Layer by layer: the share of the tasks that are there in phase one
// and in phase two, and the cells that they look at; beside what is
// expected where no border is near.
//
//     layers [POINTS]
#include "ch02-all-pairs/timing.h"
#include "ch07-spiral/expected.h"
#include "ch08-vector-spiral/fused.h"
#include "ch08-vector-spiral/march.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

enum { LAYERS_PRINTED = 4 };

//> Expect tasks and cells of a layer
static double expected_seeking(double c, int k)
{
    return k ? exp(-c * (2 * k - 1) * (2 * k - 1)) : 1;
}

static double expected_shown(double c, int k)
{
    double cells = 0;
    for (int dy = -k; dy <= k; dy++)
        for (int dx = -k; dx <= k; dx++)
            if (abs(dx) == k || abs(dy) == k)
                cells += expected_looks(c, dx, dy);
    return cells;
}
//<

static void print_layer(const struct tally *tally, double n, double c,
                        int k)
{
    printf("layer_%d\t%.0f\t%d\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g\n", k, n,
           k, tally->seeking[k] / n, expected_seeking(c, k),
           tally->looking[k] / n, tally->shown[k] / n,
           expected_shown(c, k));
}

int main(int argc, char **argv)
{
    fail_as("layers");
    uint32_t n = argument(argc, argv, 1, "POINTS", 1000000, 1000, MANY);
    struct question question = uniform_question(WRAPAROUND, n, 1);
    struct answers answers = answers_allocate(n);
    struct loops loops = loops_fused(isa_chosen());
    question.threads = omp_get_num_procs();
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    struct tally tally;
    march(&question, &grid, &cells, &loops, STRIP, &answers, &tally,
          NULL);
    report_provenance(stdout);
    puts("name\tn\tlayer\tseeking\texpected_seeking\tlooking\tshown"
         "\texpected_shown");
    for (int k = 0; k < LAYERS_PRINTED; k++)
        print_layer(&tally, n, (double)n / grid_cells(&grid), k);
    cells_free(&cells);
    grid_free(&grid);
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
//<
