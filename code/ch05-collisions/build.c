//> Time every step of a search by cells
// Fits the grid, sorts the points into it, copies them in this order
// and searches: as chapter 4 does on one thread, and with the sort by
// bands, on one and on all processors.
//
//     build [POINTS [TRIALS]]
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/together.h"
#include "ch05-collisions/bands.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>

//> Take the steps one at a time
struct steps {
    struct question question;
    struct sorted sorted; // what the other steps have found
    struct answers *answers;
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

static void sort_with_threads(void *context)
{
    struct steps *s = context;
    struct cells cells = cells_sort_threads(
        &s->sorted.grid, s->question.points, s->question.threads);
    cells_free(&cells);
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
    search_together(&s->question, &s->sorted, s->answers);
}
//<

//> List the steps, before and after
enum { STEPS = 4, WAYS = 3 };

static const char *const step_names[STEPS] = {"fit", "sort", "order",
                                              "search"};
static void (*const works[WAYS][STEPS])(void *) = {
    {fit, sort, put_in_order, search}, // chapter 4
    {fit, sort_with_threads, put_in_order, search},
    {fit, sort_with_threads, put_in_order, search},
};
//<

//> Time all steps in turn
int main(int argc, char **argv)
{
    fail_as("build");
    uint32_t n = argument(argc, argv, 1, "POINTS", 1000000, 2, MANY);
    int count = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    struct steps one = {.question = uniform_question(STANDARD, n, 1)};
    struct answers answers = answers_allocate(n);
    one.sorted =
        sorted_make(&one.question, POINTS_PER_CELL, cells_sort_alone);
    one.answers = &answers;
    struct steps all = one;
    all.question.threads = omp_get_num_procs();
    struct trial trials[WAYS * STEPS];
    for (int k = 0; k < WAYS * STEPS; k++)
        trials[k] =
            (struct trial){.work = works[k / STEPS][k % STEPS],
                           .prepare = works[k / STEPS][k % STEPS],
                           .context = k / STEPS < 2 ? &one : &all};
    time_in_turn(count, trials, WAYS * STEPS);
    report_provenance(stdout);
    puts("name\tn\tthreads\tbefore\tbefore_q1\tbefore_q3"
         "\tone\tone_q1\tone_q3\tall\tall_q1\tall_q3");
    for (int step = 0; step < STEPS; step++) {
        printf("%s\t%u\t%d", step_names[step], n, all.question.threads);
        for (int way = 0; way < WAYS; way++)
            print_summary(&trials[way * STEPS + step].summary, n);
        puts("");
    }
    answers_free(&answers);
    sorted_free(&one.sorted);
    points_free(&one.question.points);
    return 0;
}
//<
//<
