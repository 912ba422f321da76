// Times the same instructions with and without surprises: the steps
// split and blocks in the wraparound geometry, on points in the whole
// box and on the same points pressed into a quarter of it, where the
// direct way is always the shorter one.
//
//     surprises [POINTS [ROWS [TRIALS]]]
#include "ch02-all-pairs/experiments/rows.h"
#include "ch02-all-pairs/ladder.h"
#include "common/experiment.h"
#include <stdio.h>

static const char *const names[] = {"split", "blocks"};

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 8192, 2, MANY);
    uint32_t rows = parameter(&e, "ROWS", 512, 1, n);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question whole = uniform_question(WRAPAROUND, n, 1);
    struct question quarter = uniform_question(WRAPAROUND, n, 1);
    for (uint32_t i = 0; i < n; i++) {
        quarter.points.x[i] /= 4;
        quarter.points.y[i] /= 4;
    }
    struct answers answers = answers_allocate(n);
    rows_function *const rows_of[] = {split_rows, blocks_rows};
    struct run runs[4];
    struct trial versions[4];
    for (int v = 0; v < 4; v++) {
        runs[v] =
            (struct run){rows_of[v / 2], v % 2 ? &quarter : &whole,
                         &answers, 0, rows};
        versions[v] =
            (struct trial){.work = run_rows, .context = &runs[v]};
    }
    time_in_turn(trials, versions, 4);

    columns(&e, "name whole:3 quarter:3");
    for (int v = 0; v < 4; v += 2)
        row_of_times(&versions[v], 2, (double)rows * (n - 1), "%s",
                     names[v / 2]);
    answers_free(&answers);
    points_free(&quarter.points);
    points_free(&whole.points);
    return 0;
}
