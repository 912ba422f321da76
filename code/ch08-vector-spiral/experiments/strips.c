// Nanoseconds a point of the search in step, without the sort, by
// primitives and with fused kernels, and how full the vectors are; over
// the number of tasks in a strip. And how many tasks fill the caches.
//     strips [POINTS [TRIALS [LONGEST]]]
#include "ch06-pack-scan/experiments/caches.h"
#include "ch08-vector-spiral/by_primitives.h"
#include "ch08-vector-spiral/lockstep.h"
#include "ch08-vector-spiral/spiral_kernels.h"
#include "common/experiment.h"

enum { WAYS = 2, MOST_TURNS = 20 * WAYS };

struct strips {
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
    struct strips *s = context;
    struct strip_plan plan = {s->kernels, s->length, &s->tally};
    search_in_lockstep(s->question, s->grid, s->cells, &plan,
                       s->answers);
}

static void print_length(const struct strips *strips,
                         const struct trial *trials)
{
    const struct tally *tally = &strips->tally;
    struct caches caches = caches_of_machine();
    double n = strips->question->points.n;
    row_begin("length_%u\t%u", strips->length, strips->length);
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
    uint32_t longest = parameter(&e, "LONGEST", 16384, 4, 1 << 20);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    const struct spiral_kernels *kernels[WAYS] = {
        &spiral_by_primitives[isa_chosen()],
        spiral_kernels(isa_chosen())};
    struct strips strips[MOST_TURNS];
    struct trial turns[MOST_TURNS];
    int count = 0;
    for (uint32_t length = 4; length <= longest; length *= 2)
        for (int way = 0; way < WAYS; way++, count++) {
            strips[count] =
                (struct strips){&question, &grid,        &cells,
                                answers,   kernels[way], length};
            turns[count] = (struct trial){run_strips, &strips[count]};
        }
    time_in_turn(trials, turns, count);
    print_header(
        &e, "name length primitives:3 fused:3 points lanes unpacked"
            " l1_tasks l2_tasks");
    for (int k = 0; k < count; k += WAYS)
        print_length(&strips[k], &turns[k]);
}
