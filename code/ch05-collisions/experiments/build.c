// Fits the grid, sorts the points into it, copies them in this order
// and searches: as chapter 4 does on one thread, and by partition,
// which sorts and copies in one, on one and on all processors.
//     build [POINTS [TRIALS]]
#include "ch04-cell-sort/batches.h"
#include "ch05-collisions/partition.h"
#include "common/experiment.h"

struct steps {
    struct question question;
    struct sorted sorted; // what the other steps have found
    struct answers *answers;
    struct workspace *workspace;
};

static void fit(void *context)
{
    struct steps *s = context;
    struct grid grid = grid_fit(&s->question, POINTS_PER_CELL);
    grid_free(&grid);
}

static void sort(void *context)
{
    struct steps *s = context;
    struct cells cells =
        cells_sort(&s->sorted.grid, s->question.points);
    cells_free(&cells);
}

static void sort_and_copy(void *context)
{
    struct steps *s = context;
    struct mark mark = workspace_mark(s->workspace);
    partition_points(&s->sorted.grid, s->question.points,
                     s->question.threads, NO_RESTORE, s->workspace);
    workspace_release(s->workspace, mark);
}

static void do_nothing(void *context)
{
    (void)context;
}

static void put_in_order(void *context)
{
    struct steps *s = context;
    struct points sorted = points_in_order(
        s->question.points, s->sorted.cells.point, s->question.threads);
    points_free(&sorted);
}

static void search(void *context)
{
    struct steps *s = context;
    search_batches(&s->question, &s->sorted, s->answers);
}

enum { STEPS = 4, WAYS = 3 };

static const char *const step_names[STEPS] = {"fit", "sort", "order",
                                              "search"};
static void (*const works[WAYS][STEPS])(void *) = {
    {fit, sort, put_in_order, search}, // chapter 4
    {fit, sort_and_copy, do_nothing, search},
    {fit, sort_and_copy, do_nothing, search},
};

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000000, 2, MANY);
    int count = parameter(&e, "TRIALS", 3, 1, MANY);
    struct workspace workspace = {0};
    struct steps one = {.question = uniform_question(STANDARD, n, 1),
                        .answers = new_answers(n, BOTH),
                        .workspace = &workspace};
    one.sorted = sorted_make(&one.question, POINTS_PER_CELL);
    struct steps all = one;
    all.question.threads = omp_get_num_procs();
    struct trial trials[STEPS * WAYS];
    for (int k = 0; k < STEPS * WAYS; k++) {
        void (*work)(void *) = works[k % WAYS][k / WAYS];
        trials[k] =
            (struct trial){.work = work,
                           .prepare = work,
                           .context = k % WAYS < 2 ? &one : &all};
    }
    time_in_turn(count, trials, STEPS * WAYS);
    print_header(&e, "name n threads before:3 one:3 all:3");
    for (int step = 0; step < STEPS; step++)
        row_of_times(&trials[step * WAYS], WAYS, n, "%s\t%u\t%d",
                     step_names[step], n, all.question.threads);
}
