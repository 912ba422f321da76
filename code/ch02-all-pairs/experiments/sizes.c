// One point that meets eight candidates at once, against eight points
// that meet one: how the time of a pair depends on where the points
// fit, in the caches or beyond.
//
//     sizes [MOST [PAIRS [TRIALS]]]
#include "ch02-all-pairs/experiments/rows.h"
#include "ch02-all-pairs/ladder.h"
#include "ch02-all-pairs/tiles.h"
#include "common/experiment.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 1 << 17, 512, MANY);
    double pairs = parameter(&e, "PAIRS", 8000000, 1, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);

    columns(&e, "name n kilobytes lanes_ns:3 queries_ns:3 tiles_ns:3");
    for (uint64_t n = 512; n <= most; n *= 2) {
        struct question question = uniform_question(STANDARD, n, 1);
        struct answers answers = answers_allocate(n);
        rows_function *ways[] = {lanes_rows, queries_rows, tiles_rows};
        uint32_t rows = (uint32_t)fmin(n, fmax(8, pairs / n)) / 8 * 8;
        struct run runs[3];
        struct trial versions[3];
        for (int v = 0; v < 3; v++) {
            runs[v] =
                (struct run){ways[v], &question, &answers, 0, rows};
            versions[v] =
                (struct trial){.work = run_rows, .context = &runs[v]};
        }
        time_in_turn(trials, versions, 3);
        row_of_times(versions, 3, (double)rows * (n - 1),
                     "n_%u\t%u\t%u", (unsigned)n, (unsigned)n,
                     (unsigned)(n * 2 * sizeof(double) / 1024));
        answers_free(&answers);
        points_free(&question.points);
    }
    return 0;
}
