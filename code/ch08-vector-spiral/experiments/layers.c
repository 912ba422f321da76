// Layer by layer: the share of the tasks that are there in phase one
// and in phase two, and the cells that they visit; beside what is
// expected where no border is near.
//     layers [POINTS]
#include "ch07-spiral/experiments/expected.h"
#include "ch08-vector-spiral/lockstep.h"
#include "ch08-vector-spiral/spiral_kernels.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include "common/experiment.h"

enum { LAYERS_PRINTED = 4 };

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
                cells += expected_visits(c, dx, dy);
    return cells;
}

static void print_layer(const struct tally *tally, double n, double c,
                        int k)
{
    row("layer_%d\t%.0f\t%d\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g", k, n, k,
        tally->phase_one[k] / n, expected_seeking(c, k),
        tally->phase_two[k] / n, tally->of_layer[k] / n,
        expected_shown(c, k));
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000000, 1000, MANY);
    struct question question = uniform_question(WRAPAROUND, n, 1);
    question.threads = omp_get_num_procs();
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    struct tally tally;
    struct strip_plan plan = {spiral_kernels(isa_chosen()), STRIP,
                              &tally};
    search_in_lockstep(&question, &grid, &cells, &plan,
                       new_answers(n, NEAREST));
    print_header(&e,
                 "name n layer seeking expected_seeking looking shown"
                 " expected_shown");
    for (int k = 0; k < LAYERS_PRINTED; k++)
        print_layer(&tally, n, (double)n / grid_cells(&grid), k);
}
