// Random boxes have one size and lie anywhere; boxes around points are
// as large as a k-d tree says that some neighbors are far.
#include "ch12-range-queries/experiments/query_workload.h"
#include "ch12-range-queries/generate_set.h"
#include "ch12-range-queries/kd_tree.h"
#include <math.h>

static const double patience_ns = 1e6;

struct query_workload *workload_of(const char *kind, uint32_t n, int d)
{
    struct query_workload *workload = take(1, sizeof *workload);
    workload->points = generate_set(find_distribution(kind), n, d, 1);
    workload->all = range_of(&workload->points, 0, n);
    workload->found = take(n, sizeof *workload->found);
    return workload;
}

void workload_free(struct query_workload *workload)
{
    point_set_free(&workload->points);
    forget();
}

void boxes_anywhere(struct query_workload *workload, double share)
{
    struct random random = {29};
    for (int q = 0; q < MAX_BOXES; q++)
        workload->box[q] = random_range(
            &workload->all, workload->points.d, share, &random);
}

// How far the neighbor of a number is.
static double reach(const struct kd_tree *tree, const double *place,
                    uint32_t neighbors)
{
    struct found found[64];
    struct neighbor_query query = {
        .at = place, .self = NO_INDEX, .found = found};
    want_nearest(&query, neighbors);
    kd_neighbors(tree, &query);
    return sqrt(query.reach2);
}

void boxes_around_points(struct query_workload *workload,
                         uint32_t neighbors)
{
    const struct point_set *p = &workload->points;
    struct random random = {31};
    struct kd_tree tree = kd_make(p, KD_LEAF_SIZE, 1);
    for (int q = 0; q < MAX_BOXES; q++) {
        double place[MAX_DIMENSIONS];
        const uint32_t i = random_bits(&random) % p->n;
        for (int k = 0; k < p->d; k++)
            place[k] = p->x[k][i];
        const double half = reach(&tree, place, neighbors);
        for (int k = 0; k < p->d; k++) {
            workload->box[q].low[k] = place[k] - half;
            workload->box[q].high[k] = place[k] + half;
        }
    }
    kd_free(&tree);
}

// Adds to the sum what box q has cost.
static void ask(struct query_workload *workload,
                const struct structure *structure, const void *built,
                int q, struct report *sum)
{
    struct report report = {workload->found};
    structure->query(built, &workload->box[q], &report);
    sum->count += report.count;
    sum->steps += report.steps;
    sum->tested += report.tested;
}

// Says how many boxes it had time for.
static int ask_once(struct query_workload *workload,
                    const struct structure *structure,
                    const void *built, struct report *sum)
{
    const int64_t start = clock_ns();
    int asked = 0;
    while (asked < MAX_BOXES && clock_ns() - start < patience_ns)
        ask(workload, structure, built, asked++, sum);
    return asked;
}

struct cost ask_boxes(struct query_workload *workload,
                      const struct structure *structure,
                      const void *built, int trials)
{
    double ns[MAX_TRIALS];
    struct cost cost = {0};
    for (int trial = -1; trial < trials; trial++) {
        struct report sum = {0};
        const int64_t start = clock_ns();
        const int asked = ask_once(workload, structure, built, &sum);
        if (trial < 0)
            continue; // to warm up
        ns[trial] = (clock_ns() - start) / (double)asked;
        cost.found = (double)sum.count / asked;
        cost.steps = (double)sum.steps / asked;
        cost.tested = (double)sum.tested / asked;
    }
    cost.ns = summarize(ns, trials);
    return cost;
}

struct cost build_and_ask(struct query_workload *workload,
                          const struct structure *structure, int trials)
{
    void *built = structure->build(&workload->points, 1);
    const struct cost cost =
        ask_boxes(workload, structure, built, trials);
    structure->discard(built);
    return cost;
}

struct report ask_all(struct query_workload *workload,
                      const struct structure *structure)
{
    void *built = structure->build(&workload->points, 1);
    struct report sum = {0};
    for (int q = 0; q < MAX_BOXES; q++)
        ask(workload, structure, built, q, &sum);
    structure->discard(built);
    return sum;
}

void move_points(struct query_workload *workload, double max_step)
{
    const struct point_set *p = &workload->points;
    struct random random = {37};
    for (int k = 0; k < p->d; k++)
        for (uint32_t i = 0; i < p->n; i++)
            p->x[k][i] += max_step * (2 * random_uniform(&random) - 1);
    workload->all = range_of(p, 0, p->n);
}
