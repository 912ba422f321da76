// All steps in turn, in both geometries, and in between the vector
// units' peaks: what they achieve and what could be achieved, measured
// in one run.
//
//     climb [POINTS [ROWS [TRIALS]]]
#include "ch02-all-pairs/experiments/peak.h"
#include "ch02-all-pairs/experiments/rows.h"
#include "ch02-all-pairs/ladder.h"
#include "common/allocate.h"
#include "common/experiment.h"
#include <stdlib.h>

static void print_limit(const char *name, const struct trial *peaks,
                        struct bill standard, struct bill wraparound)
{
    double ns[3][PEAKS];
    for (int peak = 0; peak < PEAKS; peak++) {
        ns[0][peak] =
            peaks[peak].summary.median / peak_operations[peak];
        ns[1][peak] = peaks[peak].summary.q1 / peak_operations[peak];
        ns[2][peak] = peaks[peak].summary.q3 / peak_operations[peak];
    }
    row_begin("%s", name);
    for (int k = 0; k < 3; k++)
        row_cells("\t%.4g", peak_limit(ns[k], standard));
    for (int k = 0; k < 3; k++)
        row_cells("\t%.4g", peak_limit(ns[k], wraparound));
    row_end();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 8192, 2, MANY);
    uint32_t rows = parameter(&e, "ROWS", 512, 1, n);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question questions[2];
    questions[0] = questions[1] = uniform_question(STANDARD, n, 1);
    questions[1].space.geometry = WRAPAROUND;
    struct answers answers = answers_allocate(n);

    int count = 2 * step_count + PEAKS;
    struct run *runs = allocate(2 * step_count, sizeof *runs);
    struct trial *versions = allocate(count, sizeof *versions);
    for (int v = 0; v < 2 * step_count; v++) {
        runs[v] = (struct run){steps[v / 2].rows, &questions[v % 2],
                               &answers, 0, rows};
        versions[v] =
            (struct trial){.work = run_rows, .context = &runs[v]};
    }
    peak_versions(versions + 2 * step_count);
    time_in_turn(trials, versions, count);

    columns(&e, "name standard:3 wraparound:3");
    for (int step = 0; step < step_count; step++) {
        row_begin("%s", steps[step].name);
        for (int g = 0; g < 2; g++)
            row_times(&versions[2 * step + g].summary,
                      (double)rows * (n - 1));
        row_end();
    }

    // A subtraction is an addition, a maximum a minimum. Two of the
    // subtractions can be handed over to the multipliers.
    const struct trial *peaks = versions + 2 * step_count;
    print_limit("limit", peaks, (struct bill){3, 2, 0, 2},
                (struct bill){6, 4, 0, 6});
    print_limit("limit_tiles", peaks, (struct bill){1, 2, 2, 2},
                (struct bill){4, 4, 2, 6});
    free(runs);
    free(versions);
    answers_free(&answers);
    points_free(&questions[0].points);
    return 0;
}
