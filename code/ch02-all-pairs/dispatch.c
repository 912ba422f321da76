//> Time three ways to choose the geometry
// The same loop with a pointer, with a flag, and as a copy for each
// geometry; once as the coursework has it, once over lanes. ROWS is
// rounded down to a multiple of sixteen, as many as the lanes.
//
//     dispatch [POINTS [ROWS [TRIALS]]]
#include "ch02-all-pairs/choices.h"
#include "ch02-all-pairs/timing.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

enum { WAYS = 3, LOOPS = 2, GEOMETRIES = 2 };

static const char *const names[WAYS] = {"pointer", "flag", "copies"};
static rows_function *const ways[WAYS][LOOPS] = {
    {pointer_rows, pointer_lanes_rows},
    {flag_rows, flag_lanes_rows},
    {copies_rows, copies_lanes_rows},
};

int main(int argc, char **argv)
{
    fail_as("dispatch");
    uint32_t n = argument(argc, argv, 1, "POINTS", 8192, 16, MANY);
    uint32_t rows = argument(argc, argv, 2, "ROWS", 256, 16, n);
    rows = rows / 16 * 16;
    int trials = argument(argc, argv, 3, "TRIALS", 5, 1, MANY);
    struct question questions[GEOMETRIES];
    questions[0] = questions[1] = uniform_question(STANDARD, n, 1);
    questions[1].space.geometry = WRAPAROUND;
    struct answers answers = answers_allocate(n);

    //> Time all twelve in turn
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
    //<
    report_provenance(stdout);
    puts("name\tstandard\tstandard_q1\tstandard_q3"
         "\twraparound\twraparound_q1\twraparound_q3"
         "\tlanes\tlanes_q1\tlanes_q3"
         "\twrap_lanes\twrap_lanes_q1\twrap_lanes_q3");
    for (int w = 0; w < WAYS; w++) {
        printf("%s", names[w]);
        for (int l = 0; l < LOOPS; l++)
            for (int g = 0; g < GEOMETRIES; g++)
                print_summary(&versions[w][l][g].summary,
                              (double)rows * n);
        puts("");
    }
    answers_free(&answers);
    points_free(&questions[0].points);
    return 0;
}
//<
