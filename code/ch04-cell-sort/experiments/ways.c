// One thread, one run: what it costs to build lists, to sort indices,
// to move the points as well, and what a search costs on each; the
// queries come in the order of the input, or of the cells.
//
//     ways [POINTS [TRIALS]]
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/experiment.h"
#include <stddef.h>

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

static void search_by_lists(void *context)
{
    struct bench *b = context;
    search_lists(&b->question, &b->sorted.grid, &b->lists, NULL,
                 &b->answers);
}

static void search_by_lists_in_order(void *context)
{
    struct bench *b = context;
    search_lists(&b->question, &b->sorted.grid, &b->lists,
                 b->sorted.cells.point, &b->answers);
}

static void search_by_indices(void *context)
{
    struct bench *b = context;
    search_indices(&b->question, &b->sorted.grid, &b->sorted.cells,
                   NULL, &b->answers);
}

static void search_by_indices_in_order(void *context)
{
    struct bench *b = context;
    search_indices(&b->question, &b->sorted.grid, &b->sorted.cells,
                   b->sorted.cells.point, &b->answers);
}

static void search_by_sorted(void *context)
{
    struct bench *b = context;
    search_sorted(&b->question, &b->sorted, &b->answers);
}

static void search_by_batches(void *context)
{
    struct bench *b = context;
    search_batches(&b->question, &b->sorted, &b->answers);
}

static const struct {
    const char *name;
    void (*work)(void *);
    void (*prepare)(void *); // for those that need new memory
} ways[] = {
    {"build_lists", make_lists, make_lists},
    {"build_indices", make_cells, make_cells},
    {"move_points", move_points, move_points},
    {"lists", search_by_lists, NULL},
    {"lists_in_order", search_by_lists_in_order, NULL},
    {"indices", search_by_indices, NULL},
    {"indices_in_order", search_by_indices_in_order, NULL},
    {"sorted", search_by_sorted, NULL},
    {"batches", search_by_batches, NULL},
};
enum { WAYS = sizeof ways / sizeof *ways };

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct bench b = {.question = uniform_question(STANDARD, n, 1),
                      .answers = answers_allocate(n)};
    b.sorted.grid = grid_fit(&b.question, POINTS_PER_CELL);
    struct trial versions[WAYS];
    for (int w = 0; w < WAYS; w++)
        versions[w] = (struct trial){.work = ways[w].work,
                                     .prepare = ways[w].prepare,
                                     .context = &b};
    time_in_turn(trials, versions, WAYS);
    columns(&e, "name n ns:3");
    for (int w = 0; w < WAYS; w++) {
        row_of_times(&versions[w], 1, n, "%s\t%u", ways[w].name, n);
    }
    lists_free(&b.lists);
    sorted_free(&b.sorted);
    points_free(&b.question.points);
    answers_free(&b.answers);
    return 0;
}
