// The same loop with a pointer, with a flag, and as a copy for each
// geometry; once as the coursework has it, once over lanes. ROWS is
// rounded down to a multiple of sixteen, as many as the lanes.
//     dispatch [POINTS [ROWS [TRIALS]]]
#include "ch02-all-pairs/experiments/choices.h"
#include "ch02-all-pairs/experiments/rows.h"

enum { WAYS = 3, LOOPS = 2, GEOMETRIES = 2 };

static const char *const names[WAYS] = {"pointer", "flag", "copies"};
static rows_function *const ways[WAYS * LOOPS] = {
    pointer_rows,    pointer_lanes_rows, flag_rows,
    flag_lanes_rows, copies_rows,        copies_lanes_rows};

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 8192, 16, MANY);
    uint32_t rows = parameter(&e, "ROWS", 256, 16, n) / 16 * 16;
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    enum { EACH = LOOPS * GEOMETRIES, ALL = WAYS * EACH };
    struct trial versions[ALL];
    for (int v = 0; v < ALL; v++) {
        question.space.geometry =
            v % GEOMETRIES ? WRAPAROUND : STANDARD;
        versions[v] =
            rows_trial(ways[v / GEOMETRIES], &question, answers, rows);
    }
    time_in_turn(trials, versions, ALL);
    print_header(&e,
                 "name standard:3 wraparound:3 lanes:3 wrap_lanes:3");
    for (int w = 0; w < WAYS; w++)
        row_of_times(&versions[w * EACH], EACH, (double)rows * n, "%s",
                     names[w]);
}
