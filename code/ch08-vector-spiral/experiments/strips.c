// Nanoseconds a point of the search in step, without the sort, by
// primitives and with fused kernels, and how full the vectors are; over
// the number of tasks in a strip. And how many tasks fill the caches.
//
//     strips [POINTS [TRIALS [LONGEST]]]
#include "ch06-pack-scan/experiments/caches.h"
#include "ch08-vector-spiral/advance.h"
#include "ch08-vector-spiral/by_primitives.h"
#include "ch08-vector-spiral/spiral_kernels.h"
#include "common/experiment.h"

enum { SHORTEST = 4, MOST_LENGTHS = 20, WAYS = 2 };

struct run_of_strips {
    const struct question *question;
    const struct grid *grid;
    const struct cells *cells;
    struct answers *answers;
    const struct spiral_kernels *kernels;
    uint32_t length;
    struct tally tally; // set by run_strips
};

static void run_strips(void *context)
{
    struct run_of_strips *run = context;
    struct strip_plan plan = {run->kernels, run->length, &run->tally,
                              NULL};
    advance_tasks(run->question, run->grid, run->cells, &plan,
                  run->answers);
}

static void print_length(const struct run_of_strips *run,
                         const struct trial *trials)
{
    const struct tally *tally = &run->tally;
    struct caches caches = caches_of_machine();
    double n = run->question->points.n;
    row_begin("length_%u\t%u", run->length, run->length);
    for (int way = 0; way < WAYS; way++)
        row_times(&trials[way].summary, n);
    row_cells("\t%.5g\t%.5g\t%.5g\t%zu\t%zu", tally->compared / n,
              tally->lanes / n, tally->lanes_unpacked / n,
              caches.l1 / TASK_BYTES, caches.l2 / TASK_BYTES);
    row_end();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    uint32_t longest =
        parameter(&e, "LONGEST", 16384, SHORTEST, 1 << 20);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers answers = answers_allocate(n);
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    const struct spiral_kernels *kernels[WAYS] = {
        &spiral_by_primitives[isa_chosen()],
        spiral_kernels(isa_chosen())};
    struct run_of_strips runs[MOST_LENGTHS * WAYS];
    struct trial turns[MOST_LENGTHS * WAYS];
    int count = 0;
    for (uint32_t length = SHORTEST; length <= longest; length *= 2)
        for (int way = 0; way < WAYS; way++, count++) {
            runs[count] = (struct run_of_strips){
                &question,    &grid,  &cells, &answers,
                kernels[way], length, {0}};
            turns[count] = (struct trial){run_strips, &runs[count]};
        }
    time_in_turn(trials, turns, count);
    columns(&e, "name length primitives:3 fused:3 points lanes unpacked"
                " l1_tasks l2_tasks");
    for (int k = 0; k < count; k += WAYS)
        print_length(&runs[k], &turns[k]);
    cells_free(&cells);
    grid_free(&grid);
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
