// One thread, one run: what it costs to build lists, to sort indices,
// to move the points as well, and what a search costs on each; the
// queries come in the order of the input, or of the cells.
//     ways [POINTS [TRIALS]]
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/experiments/bench.h"

// What is built again takes the place of what was there.
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

static const char *const names[] = {
    "build_lists",    "build_indices", "move_points",      "lists",
    "lists_in_order", "indices",       "indices_in_order", "sorted",
    "batches"};
enum { WAYS = COUNT_OF(names), BUILDS = 3 };

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct bench b =
        bench_make(uniform_question(STANDARD, n, 1), POINTS_PER_CELL);
    struct trial versions[WAYS] = {
        {make_lists, &b, .prepare = make_lists}, // for new memory
        {make_cells, &b, .prepare = make_cells},
        {move_points, &b, .prepare = move_points}};
    for (int w = BUILDS; w < WAYS; w++)
        versions[w] = bench_trial(&b, names[w]);
    time_in_turn(trials, versions, WAYS);
    print_header(&e, "name n ns:3");
    for (int w = 0; w < WAYS; w++)
        row_of_times(&versions[w], 1, n, "%s\t%u", names[w], n);
}
