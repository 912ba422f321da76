//> Time three ways to hold the cells
// One thread, one run: what it costs to build lists, to sort indices,
// to move the points as well, and what a search costs on each; the
// points ask in the order of the input, or of the cells.
//
//     ways [POINTS [TRIALS]]
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/point_by_point.h"
#include "ch04-cell-sort/together.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

//> Hold everything that is timed
struct bench {
    struct question question;
    struct sorted sorted; // made and timed in two steps
    struct lists lists;
    struct answers answers;
};

static void make_lists(void *context)
{
    struct bench *b = context;
    lists_free(&b->lists);
    b->lists = lists_make(&b->sorted.grid, b->question.points);
}

static void make_cells(void *context)
{
    struct bench *b = context;
    struct sorted *s = &b->sorted;
    cells_free(&s->cells);
    s->cells = cells_sort(&s->grid, b->question.points);
}

static void move_points(void *context)
{
    struct bench *b = context;
    struct sorted *s = &b->sorted;
    points_free(&s->points);
    s->points = points_in_order(b->question.points, s->cells.point, 1);
}

static void ask_lists(void *context)
{
    struct bench *b = context;
    search_lists(&b->question, &b->sorted.grid, &b->lists, NULL,
                 &b->answers);
}

static void ask_lists_in_order(void *context)
{
    struct bench *b = context;
    search_lists(&b->question, &b->sorted.grid, &b->lists,
                 b->sorted.cells.point, &b->answers);
}

static void ask_indices(void *context)
{
    struct bench *b = context;
    search_indices(&b->question, &b->sorted.grid, &b->sorted.cells,
                   NULL, &b->answers);
}

static void ask_indices_in_order(void *context)
{
    struct bench *b = context;
    search_indices(&b->question, &b->sorted.grid, &b->sorted.cells,
                   b->sorted.cells.point, &b->answers);
}

static void ask_sorted(void *context)
{
    struct bench *b = context;
    search_sorted(&b->question, &b->sorted, &b->answers);
}

static void ask_together(void *context)
{
    struct bench *b = context;
    search_together(&b->question, &b->sorted, &b->answers);
}
//<

static const struct {
    const char *name;
    void (*work)(void *);
    void (*prepare)(void *); // for those that need new memory
} ways[] = {
    {"build_lists", make_lists, make_lists},
    {"build_indices", make_cells, make_cells},
    {"move_points", move_points, move_points},
    {"lists", ask_lists, NULL},
    {"lists_in_order", ask_lists_in_order, NULL},
    {"indices", ask_indices, NULL},
    {"indices_in_order", ask_indices_in_order, NULL},
    {"sorted", ask_sorted, NULL},
    {"together", ask_together, NULL},
};
enum { WAYS = sizeof ways / sizeof *ways };

int main(int argc, char **argv)
{
    fail_as("ways");
    uint32_t n = argument(argc, argv, 1, "POINTS", 100000, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    struct bench b = {.question = uniform_question(STANDARD, n, 1),
                      .answers = answers_allocate(n)};
    b.sorted.grid = grid_fit(&b.question, POINTS_PER_CELL);
    struct trial versions[WAYS];
    for (int w = 0; w < WAYS; w++)
        versions[w] = (struct trial){.work = ways[w].work,
                                     .prepare = ways[w].prepare,
                                     .context = &b};
    time_in_turn(trials, versions, WAYS);
    report_provenance(stdout);
    puts("name\tn\tns\tns_q1\tns_q3");
    for (int w = 0; w < WAYS; w++) {
        printf("%s\t%u", ways[w].name, n);
        print_summary(&versions[w].summary, n);
        puts("");
    }
    lists_free(&b.lists);
    sorted_free(&b.sorted);
    points_free(&b.question.points);
    answers_free(&b.answers);
    return 0;
}
//<
