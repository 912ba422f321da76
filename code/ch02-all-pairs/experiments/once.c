// Runs the steps of the ladder once, for tools that count what a
// processor would do: nothing is timed, nothing is printed. If QUARTER
// is 1, all points lie in a quarter of the box, the direct way is
// always shorter, and no decision of in_wraparound can surprise.
//     once [GEOMETRY [POINTS [ROWS [QUARTER]]]]
#include "ch02-all-pairs/experiments/rows.h"
#include "ch02-all-pairs/ladder.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    enum geometry geometry = (enum geometry)parameter(
        &e, "GEOMETRY", STANDARD, STANDARD, WRAPAROUND);
    uint32_t n = parameter(&e, "POINTS", 4096, 2, MANY);
    uint32_t rows = parameter(&e, "ROWS", 64, 1, n);
    bool quarter = parameter(&e, "QUARTER", 0, 0, 1);
    struct question question = question_in(quarter, geometry, n);
    struct answers *answers = new_answers(n, BOTH);
    for (int step = 0; step < step_count; step++)
        steps[step].rows(&question, answers, 0, rows);
}
