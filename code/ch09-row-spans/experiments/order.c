// Chapter 4's batches of four and row spans, on points that come in any
// order and on the same points in the order of the cells, which the
// results then need not leave; for few points, which stay in the
// caches, and for many. The search alone, two points in a cell, one
// thread.
//     order [POINTS [FEW [TRIALS]]]
#include "ch04-cell-sort/batches.h"
#include "ch09-row-spans/row_spans.h"
#include "common/experiment.h"

struct searches {
    struct question question;
    struct partition partition;
    struct workspace *workspace;
    struct answers *answers;
};

static void by_four(void *context)
{
    struct searches *s = context;
    search_batches(&s->question, &s->partition.sorted, s->answers);
}

static void by_eight(void *context)
{
    struct searches *s = context;
    search_row_spans(&s->question, &s->partition, s->workspace,
                     s->answers);
}

static struct searches searches_in(struct question question,
                                   struct workspace *workspace,
                                   struct answers *answers)
{
    return (struct searches){
        question,
        partition_make(&question, POINTS_PER_CELL, RESTORE, workspace),
        workspace, answers};
}

static void compare_orders(const char *name, uint32_t n, int trials)
{
    static const char *const orders[] = {"any", "cells"};
    enum { ORDERS = COUNT_OF(orders) };
    struct workspace workspace = {0};
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *answers = new_answers(n, NEAREST);
    struct searches in[ORDERS];
    in[0] = searches_in(question, &workspace, answers);
    question.points = in[0].partition.sorted.points;
    in[1] = searches_in(question, &workspace, answers);
    struct trial versions[2 * ORDERS];
    for (int k = 0; k < ORDERS; k++) {
        versions[2 * k] =
            (struct trial){.work = by_four, .context = &in[k]};
        versions[2 * k + 1] =
            (struct trial){.work = by_eight, .context = &in[k]};
    }
    time_in_turn(trials, versions, 2 * ORDERS);
    for (int k = 0; k < ORDERS; k++)
        row_of_times(&versions[2 * k], 2, n, "%s_%s\t%u", name,
                     orders[k], n);
    workspace_free(&workspace);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t many = parameter(&e, "POINTS", 100000, 2, MANY);
    uint32_t few = parameter(&e, "FEW", 20000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    print_header(&e, "name n four:3 eight:3");
    compare_orders("few", few, trials);
    compare_orders("many", many, trials);
}
