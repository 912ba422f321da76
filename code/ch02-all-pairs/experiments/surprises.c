// Times the same instructions with and without surprises: the steps
// split and blocks in the wraparound geometry, on points in the whole
// box and on the same points pressed into a quarter of it, where the
// direct way is always the shorter one.
//     surprises [POINTS [ROWS [TRIALS]]]
#include "ch02-all-pairs/experiments/rows.h"
#include "ch02-all-pairs/ladder.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 8192, 2, MANY);
    uint32_t rows = parameter(&e, "ROWS", 512, 1, n);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question whole = question_in(false, WRAPAROUND, n);
    struct question quarter = question_in(true, WRAPAROUND, n);
    struct answers *answers = new_answers(n, BOTH);
    struct trial versions[] = {
        rows_trial(split_rows, &whole, answers, rows),
        rows_trial(split_rows, &quarter, answers, rows),
        rows_trial(blocks_rows, &whole, answers, rows),
        rows_trial(blocks_rows, &quarter, answers, rows)};
    time_in_turn(trials, versions, 4);
    print_header(&e, "name whole:3 quarter:3");
    const double pairs = (double)rows * (n - 1);
    row_of_times(&versions[0], 2, pairs, "split");
    row_of_times(&versions[2], 2, pairs, "blocks");
}
