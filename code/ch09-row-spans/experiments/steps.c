// The search alone, from chapter 4's through indices to eight points
// together: every step in turn on the same points, in the order of the
// cells, with the distances that each computes and how many points are
// answered exactly.
//     steps [POINTS [TRIALS]]
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/point_by_point.h"
#include "ch09-row-spans/point_query.h"
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/span_kernels.h"
#include "common/experiment.h"

struct steps {
    struct question question;
    struct partition two, fewer; // in a cell; as row-spans has it
    struct workspace workspace;
    struct answers *answers;
};

static void by_indices(void *context)
{
    struct steps *s = context;
    search_indices(&s->question, &s->two.sorted.grid,
                   &s->two.sorted.cells, s->two.sorted.cells.point,
                   s->answers);
}

static void by_sorted(void *context)
{
    struct steps *s = context;
    search_sorted(&s->question, &s->two.sorted, s->answers);
}

// The exact query of row spans without its pruning.
static struct query query_all_rows(const struct scene *scene,
                                   uint32_t s)
{
    const struct grid *grid = &scene->sorted->grid;
    struct query query = query_of(scene->sorted, s);
    const uint32_t own = axis_cell(&grid->y, query.y);
    for (uint32_t radius = 1;; radius *= 2) {
        struct block block = block_of(grid, query.x, query.y, radius);
        compare_row(scene, &block.x, own, &query);
        for (uint32_t k = 0; k < block.y.count; k++) {
            uint32_t row = range_cell(&grid->y, &block.y, k);
            if (row != own)
                compare_row(scene, &block.x, row, &query);
        }
        double margin = block_margin(grid, &block, query.x, query.y);
        if (query.best2 < margin * margin || block_covers(grid, &block))
            return query;
    }
}

typedef struct query query_function(const struct scene *scene,
                                    uint32_t s);

// One query after the other, in the order of the cells.
static void query_each(struct steps *s, query_function *query,
                       const struct span_kernels *kernels)
{
    const struct sorted *sorted = &s->two.sorted;
    const uint32_t *point = sorted->cells.point;
    const struct scene scene = {s->question.space, sorted, kernels};
    struct counts counts = {.exact = sorted->points.n};
    for (uint32_t k = 0; k < sorted->points.n; k++) {
        struct query found = query(&scene, k);
        s->answers->nearest[point[k]] = found.nearest;
        s->answers->nearest2[point[k]] = found.best2;
        counts.distances += found.compared;
    }
    counts_add(s->question.counts, &counts);
}

static void by_spans(void *context)
{
    query_each(context, query_all_rows, &portable_spans);
}

static void by_vectors(void *context)
{
    query_each(context, query_all_rows, span_kernels());
}

static void by_pruning(void *context)
{
    query_each(context, nearest_query, span_kernels());
}

static void by_four(void *context)
{
    struct steps *s = context;
    search_batches(&s->question, &s->two.sorted, s->answers);
}

static void by_filter(void *context)
{
    struct steps *s = context;
    search_row_spans(&s->question, &s->two, &s->workspace, s->answers);
}

static void by_fewer(void *context)
{
    struct steps *s = context;
    search_row_spans(&s->question, &s->fewer, &s->workspace,
                     s->answers);
}

// What is counted is the work itself, but chapter 4's searches by
// points are taken to compute as many distances as they find points in
// the blocks, which is what spans find, too.
static const struct {
    const char *name;
    void (*work)(void *), (*counted)(void *);
} steps[] = {{"indices", by_indices, by_vectors},
             {"sorted", by_sorted, by_vectors},
             {"spans", by_spans, by_spans},
             {"vectors", by_vectors, by_vectors},
             {"pruned", by_pruning, by_pruning},
             {"four", by_four, by_four},
             {"filtered", by_filter, by_filter},
             {"fewer", by_fewer, by_fewer}};
enum { STEPS = COUNT_OF(steps) };

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    int count = parameter(&e, "TRIALS", 5, 1, MANY);
    struct steps s = {.question = uniform_question(STANDARD, n, 1),
                      .answers = new_answers(n, BOTH)};
    s.two = partition_make(&s.question, POINTS_PER_CELL, RESTORE,
                           &s.workspace);
    s.fewer = partition_make(&s.question, POINTS_PER_SPAN_CELL, RESTORE,
                             &s.workspace);
    struct trial trials[STEPS];
    for (int k = 0; k < STEPS; k++)
        trials[k] =
            (struct trial){.work = steps[k].work, .context = &s};
    time_in_turn(count, trials, STEPS);
    print_header(&e, "name n distances exact ns:3");
    for (int k = 0; k < STEPS; k++) {
        struct counts counts = {0};
        s.question.counts = &counts;
        steps[k].counted(&s);
        row_of_times(&trials[k], 1, n, "%s\t%u\t%.5g\t%.4g",
                     steps[k].name, n, (double)counts.distances / n,
                     (double)counts.exact / n);
    }
}
