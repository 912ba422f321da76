// See probe.h.
#include "ch12-range-queries/experiments/probe.h"
#include "ch12-range-queries/generate_set.h"
#include "ch12-range-queries/kd_tree.h"
#include <math.h>

static const double patience_ns = 1e6;

struct probe *probe_of(const char *kind, uint32_t n, int d)
{
    struct probe *probe = take(1, sizeof *probe);
    probe->points = generate_set(find_distribution(kind), n, d, 1);
    probe->all = range_of(&probe->points, 0, n);
    probe->found = take(n, sizeof *probe->found);
    return probe;
}

void probe_free(struct probe *probe)
{
    point_set_free(&probe->points);
    forget();
}

void boxes_anywhere(struct probe *probe, double share)
{
    struct random random = {29};
    for (int q = 0; q < MOST_BOXES; q++)
        probe->box[q] =
            random_range(&probe->all, probe->points.d, share, &random);
}

// How far the neighbor of a number is.
static double reach(const struct kd_tree *tree, const double *place,
                    uint32_t neighbors)
{
    uint32_t point[64];
    double distance2[64];
    struct neighbors query = {.at = place,
                              .self = NO_INDEX,
                              .point = point,
                              .distance2 = distance2};
    want_nearest(&query, neighbors);
    kd_neighbors(tree, &query);
    return sqrt(query.reach2);
}

void boxes_around_points(struct probe *probe, uint32_t neighbors)
{
    const struct point_set *p = &probe->points;
    struct random random = {31};
    struct kd_tree tree = kd_make(p, KD_LEAF, 1);
    for (int q = 0; q < MOST_BOXES; q++) {
        double place[MOST_DIMENSIONS];
        const uint32_t i = random_bits(&random) % p->n;
        for (int k = 0; k < p->d; k++)
            place[k] = p->x[k][i];
        const double half = reach(&tree, place, neighbors);
        for (int k = 0; k < p->d; k++) {
            probe->box[q].low[k] = place[k] - half;
            probe->box[q].high[k] = place[k] + half;
        }
    }
    kd_free(&tree);
}

// Says how many boxes it had time for.
static int ask_once(struct probe *probe,
                    const struct structure *structure,
                    const void *built, struct report *sum)
{
    const int64_t start = clock_ns();
    int asked = 0;
    while (asked < MOST_BOXES && clock_ns() - start < patience_ns) {
        struct report report = {probe->found};
        structure->query(built, &probe->box[asked++], &report);
        sum->count += report.count;
        sum->steps += report.steps;
        sum->tested += report.tested;
    }
    return asked;
}

struct cost ask_boxes(struct probe *probe,
                      const struct structure *structure,
                      const void *built, int trials)
{
    double ns[MOST_TRIALS];
    struct cost cost = {0};
    for (int trial = -1; trial < trials; trial++) {
        struct report sum = {0};
        const int64_t start = clock_ns();
        const int asked = ask_once(probe, structure, built, &sum);
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

struct cost build_and_ask(struct probe *probe,
                          const struct structure *structure, int trials)
{
    void *built = structure->build(&probe->points, 1);
    const struct cost cost = ask_boxes(probe, structure, built, trials);
    structure->discard(built);
    return cost;
}

struct report ask_all(struct probe *probe,
                      const struct structure *structure)
{
    void *built = structure->build(&probe->points, 1);
    struct report sum = {0};
    for (int q = 0; q < MOST_BOXES; q++) {
        struct report report = {probe->found};
        structure->query(built, &probe->box[q], &report);
        sum.count += report.count;
        sum.steps += report.steps;
        sum.tested += report.tested;
    }
    structure->discard(built);
    return sum;
}

void move_points(struct probe *probe, double most)
{
    const struct point_set *p = &probe->points;
    struct random random = {37};
    for (int k = 0; k < p->d; k++)
        for (uint32_t i = 0; i < p->n; i++)
            p->x[k][i] += most * (2 * random_uniform(&random) - 1);
    probe->all = range_of(p, 0, p->n);
}
