// Builds what each search needs, once. A search is found by its name,
// and the context of its trial is the bench.
#include "ch04-cell-sort/experiments/bench.h"
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/point_by_point.h"

static void lists(void *context)
{
    struct bench *b = context;
    search_lists(&b->question, &b->sorted.grid, &b->lists, NULL,
                 b->answers);
}

static void lists_in_order(void *context)
{
    struct bench *b = context;
    search_lists(&b->question, &b->sorted.grid, &b->lists,
                 b->sorted.cells.point, b->answers);
}

static void indices(void *context)
{
    struct bench *b = context;
    search_indices(&b->question, &b->sorted.grid, &b->sorted.cells,
                   NULL, b->answers);
}

static void indices_in_order(void *context)
{
    struct bench *b = context;
    search_indices(&b->question, &b->sorted.grid, &b->sorted.cells,
                   b->sorted.cells.point, b->answers);
}

static void sorted(void *context)
{
    struct bench *b = context;
    search_sorted(&b->question, &b->sorted, b->answers);
}

static void batches(void *context)
{
    struct bench *b = context;
    search_batches(&b->question, &b->sorted, b->answers);
}

static const struct {
    const char *name;
    void (*work)(void *);
} searches[] = {
    {"lists", lists},     {"lists_in_order", lists_in_order},
    {"indices", indices}, {"indices_in_order", indices_in_order},
    {"sorted", sorted},   {"batches", batches}};

struct bench bench_make(struct question question, double c)
{
    struct bench b = {.question = question};
    b.sorted = sorted_make(&question, c);
    b.lists = lists_make(&b.sorted.grid, question.points);
    b.answers = new_answers(question.points.n, BOTH);
    return b;
}

struct trial bench_trial(struct bench *bench, const char *name)
{
    for (int k = 0; k < COUNT_OF(searches); k++)
        if (strcmp(searches[k].name, name) == 0)
            return (struct trial){searches[k].work, bench};
    fail("there is no search called %s", name);
}
