//> Time where the time goes
// Every step of a search by row spans, on one thread and on all
// processors: fitting the grid, carrying the points, searching, with
// answers that are taken straight to their places, eight at a time or
// in long turns, or go back in parcels, or stay in the order of the
// cells; beside chapter 5's sort and copy, and beside the floor, which
// is to read every point once and to write every answer once.
//
//     phases [POINTS [TRIALS]]
#include "algorithms.h"
#include "ch02-all-pairs/timing.h"
#include "ch05-collisions/bands.h"
#include "ch09-row-spans/carry.h"
#include "ch09-row-spans/keep.h"
#include "ch09-row-spans/row_spans.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>

struct phases {
    struct question question;
    struct carried carried, at_home; // at_home: point[s] is s
    struct answers *answers;
};

//> Take the phases one at a time
static void fit(void *context)
{
    struct phases *p = context;
    struct grid grid = grid_fit(&p->question, POINTS_PER_SPAN_CELL);
    grid_free(&grid);
}

static void sort_and_copy(void *context)
{
    struct phases *p = context;
    struct sorted sorted = sorted_make(
        &p->question, POINTS_PER_SPAN_CELL, cells_sort_threads);
    sorted_free(&sorted);
}

static void fit_and_carry(void *context)
{
    struct phases *p = context;
    struct carried carried =
        carry_points(&p->question, POINTS_PER_SPAN_CELL);
    carried_free(&carried);
}

static void search(void *context)
{
    struct phases *p = context;
    search_row_spans(&p->question, &p->carried, TOGETHER, p->answers);
}

static void search_in_short_turns(void *context)
{
    struct phases *p = context;
    search_in_turns(&p->question, &p->carried.sorted, 8, p->answers);
}

static void search_in_long_turns(void *context)
{
    struct phases *p = context;
    search_in_turns(&p->question, &p->carried.sorted, LONGEST_TURN,
                    p->answers);
}

static void search_at_home(void *context)
{
    struct phases *p = context;
    search_in_turns(&p->question, &p->at_home.sorted, LONGEST_TURN,
                    p->answers);
}

static void all(void *context)
{
    struct phases *p = context;
    row_spans(&p->question, p->answers);
}
//<

//> Touch the floor
static void touch_floor(void *context)
{
    struct phases *p = context;
    const struct points points = p->question.points;
    uint32_t *nearest = p->answers->nearest;
    double *nearest2 = p->answers->nearest2;
#pragma omp parallel for num_threads(p->question.threads)
    for (uint32_t i = 0; i < points.n; i++) {
        nearest[i] = i;
        nearest2[i] = points.x[i] + points.y[i];
    }
}
//<

//> List the phases
static const struct {
    const char *name;
    void (*work)(void *);
} phases[] = {{"fit", fit},
              {"copied", sort_and_copy},
              {"carried", fit_and_carry},
              {"short_turns", search_in_short_turns},
              {"turns", search_in_long_turns},
              {"search", search},
              {"at_home", search_at_home},
              {"all", all},
              {"floor", touch_floor}};
enum { PHASES = sizeof phases / sizeof *phases };
//<

int main(int argc, char **argv)
{
    fail_as("phases");
    memory_keep();
    uint32_t n = argument(argc, argv, 1, "POINTS", 1000000, 2, MANY);
    int count = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    struct answers answers = answers_for(n, NEAREST);
    struct phases one = {.question = uniform_question(STANDARD, n, 1),
                         .answers = &answers};
    one.carried = carry_points(&one.question, POINTS_PER_SPAN_CELL);
    one.at_home = carry_points(&one.question, POINTS_PER_SPAN_CELL);
    for (uint32_t s = 0; s < n; s++)
        one.at_home.sorted.cells.point[s] = s;
    struct phases all = one;
    all.question.threads = omp_get_num_procs();
    struct trial trials[2 * PHASES];
    for (int k = 0; k < 2 * PHASES; k++)
        trials[k] = (struct trial){.work = phases[k / 2].work,
                                   .prepare = phases[k / 2].work,
                                   .context = k % 2 ? &all : &one};
    time_in_turn(count, trials, 2 * PHASES);
    report_provenance(stdout);
    puts("name\tn\tthreads\tone\tone_q1\tone_q3\tall\tall_q1\tall_q3");
    for (int k = 0; k < PHASES; k++) {
        printf("%s\t%u\t%d", phases[k].name, n, all.question.threads);
        print_summary(&trials[2 * k].summary, n);
        print_summary(&trials[2 * k + 1].summary, n);
        puts("");
    }
    carried_free(&one.at_home);
    carried_free(&one.carried);
    points_free(&one.question.points);
    answers_free(&answers);
    return 0;
}
//<
