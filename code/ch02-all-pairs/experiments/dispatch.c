// The same loop with a pointer, with a flag, and as a copy for each
// geometry; once as the coursework has it, once over lanes. ROWS is
// rounded down to a multiple of sixteen, as many as the lanes.
//
//     dispatch [POINTS [ROWS [TRIALS]]]
#include "ch02-all-pairs/experiments/choices.h"
#include "ch02-all-pairs/experiments/rows.h"
#include "common/experiment.h"

enum { WAYS = 3, LOOPS = 2, GEOMETRIES = 2 };

static const char *const names[WAYS] = {"pointer", "flag", "copies"};
static rows_function *const ways[WAYS][LOOPS] = {
    {pointer_rows, pointer_lanes_rows},
    {flag_rows, flag_lanes_rows},
    {copies_rows, copies_lanes_rows},
};

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 8192, 16, MANY);
    uint32_t rows = parameter(&e, "ROWS", 256, 16, n);
    rows = rows / 16 * 16;
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question questions[GEOMETRIES];
    questions[0] = questions[1] = uniform_question(STANDARD, n, 1);
    questions[1].space.geometry = WRAPAROUND;
    struct answers answers = answers_allocate(n);

    struct run runs[WAYS][LOOPS][GEOMETRIES];
    struct trial versions[WAYS][LOOPS][GEOMETRIES];
    for (int w = 0; w < WAYS; w++)
        for (int l = 0; l < LOOPS; l++)
            for (int g = 0; g < GEOMETRIES; g++) {
                runs[w][l][g] = (struct run){ways[w][l], &questions[g],
                                             &answers, 0, rows};
                versions[w][l][g] = (struct trial){
                    .work = run_rows, .context = &runs[w][l][g]};
            }
    time_in_turn(trials, versions[0][0], WAYS * LOOPS * GEOMETRIES);
    columns(&e, "name standard:3 wraparound:3 lanes:3 wrap_lanes:3");
    for (int w = 0; w < WAYS; w++) {
        row_begin("%s", names[w]);
        for (int l = 0; l < LOOPS; l++)
            for (int g = 0; g < GEOMETRIES; g++)
                row_times(&versions[w][l][g].summary, (double)rows * n);
        row_end();
    }
    answers_free(&answers);
    points_free(&questions[0].points);
    return 0;
}
