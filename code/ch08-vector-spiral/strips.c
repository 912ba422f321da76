//> Vary the length of a strip
// Nanoseconds a point of the march, without the sort, by primitives and
// with fused loops, and how full the vectors are; over the number of
// tasks in a strip. And how many tasks fill the caches.
//
//     strips [POINTS [TRIALS [LONGEST]]]
#include "ch02-all-pairs/timing.h"
#include "ch06-pack-scan/caches.h"
#include "ch08-vector-spiral/by_primitives.h"
#include "ch08-vector-spiral/fused.h"
#include "ch08-vector-spiral/march.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

enum { SHORTEST = 4, MOST_LENGTHS = 20, WAYS = 2 };

struct run_of_strips {
    const struct question *question;
    const struct grid *grid;
    const struct cells *cells;
    struct answers *answers;
    struct loops loops;
    uint32_t length;
    struct tally tally; // set by run_strips
};

static void run_strips(void *context)
{
    struct run_of_strips *run = context;
    march(run->question, run->grid, run->cells, &run->loops,
          run->length, run->answers, &run->tally, NULL);
}

//> Print a length
static void print_length(const struct run_of_strips *run,
                         const struct trial *trials)
{
    const struct tally *tally = &run->tally;
    struct caches caches = caches_of_machine();
    double n = run->question->points.n;
    printf("length_%u\t%u", run->length, run->length);
    for (int way = 0; way < WAYS; way++)
        print_summary(&trials[way].summary, n);
    printf("\t%.5g\t%.5g\t%.5g\t%zu\t%zu\n", tally->points / n,
           tally->lanes / n, tally->unpacked / n,
           caches.l1 / TASK_BYTES, caches.l2 / TASK_BYTES);
}
//<

int main(int argc, char **argv)
{
    fail_as("strips");
    uint32_t n = argument(argc, argv, 1, "POINTS", 20000, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    uint32_t longest =
        argument(argc, argv, 3, "LONGEST", 16384, SHORTEST, 1 << 20);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers answers = answers_allocate(n);
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    struct loops loops[WAYS] = {loops_by_primitives(isa_chosen()),
                                loops_fused(isa_chosen())};
    struct run_of_strips runs[MOST_LENGTHS * WAYS];
    struct trial turns[MOST_LENGTHS * WAYS];
    int count = 0;
    for (uint32_t length = SHORTEST; length <= longest; length *= 2)
        for (int way = 0; way < WAYS; way++, count++) {
            runs[count] = (struct run_of_strips){
                &question,  &grid,  &cells, &answers,
                loops[way], length, {0}};
            turns[count] = (struct trial){.work = run_strips,
                                          .context = &runs[count]};
        }
    time_in_turn(trials, turns, count);
    report_provenance(stdout);
    puts("name\tlength\tprimitives\tprimitives_q1\tprimitives_q3"
         "\tfused\tfused_q1\tfused_q3\tpoints\tlanes\tunpacked"
         "\tl1_tasks\tl2_tasks");
    for (int k = 0; k < count; k += WAYS)
        print_length(&runs[k], &turns[k]);
    cells_free(&cells);
    grid_free(&grid);
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
//<
