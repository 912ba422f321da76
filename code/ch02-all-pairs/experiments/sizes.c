// One query that meets eight candidates at once, against eight queries
// that meet one: how the time of a pair depends on where the points
// fit, in the caches or beyond.
//     sizes [MOST [PAIRS [TRIALS]]]
#include "ch02-all-pairs/experiments/rows.h"
#include "ch02-all-pairs/ladder.h"
#include "ch02-all-pairs/tiles.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 1 << 17, 512, MANY);
    double pairs = parameter(&e, "PAIRS", 8000000, 1, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    print_header(&e,
                 "name n kilobytes lanes_ns:3 queries_ns:3 tiles_ns:3");
    for (uint32_t n = 512; n <= most; n *= 2) {
        struct question question = uniform_question(STANDARD, n, 1);
        struct answers *answers = new_answers(n, BOTH);
        uint32_t rows = (uint32_t)fmin(n, fmax(8, pairs / n)) / 8 * 8;
        struct trial versions[] = {
            rows_trial(lanes_rows, &question, answers, rows),
            rows_trial(queries_rows, &question, answers, rows),
            rows_trial(tiles_rows, &question, answers, rows)};
        time_in_turn(trials, versions, 3);
        row_of_times(versions, 3, (double)rows * (n - 1),
                     "n_%u\t%u\t%u", n, n, n / 64);
        forget();
    }
}
