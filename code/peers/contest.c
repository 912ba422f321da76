// See contest.h. Only building and querying are on the clock; the
// answers are compared afterward, and their arrays used again.
#include "peers/contest.h"
#include "common/fail.h"
#include <math.h>
#include <stdlib.h>

// Two ways to round a sum of two squares are no further apart.
static const double rounding = 1e-15;

struct instance instance_of(struct points points)
{
    struct instance instance = {
        .points = points,
        .place = allocate(points.n, sizeof *instance.place),
        .right2 = allocate(points.n, sizeof *instance.right2),
    };
    for (uint32_t i = 0; i < points.n; i++) {
        instance.place[i][0] = points.x[i];
        instance.place[i][1] = points.y[i];
    }
    return instance;
}

void instance_free(struct instance *instance)
{
    points_free(&instance->points);
    free(instance->place);
    free(instance->right2);
}

// The book's programs release what they built while the clock runs, the
// others afterward.
struct run {
    double build, query;
};

static struct run run_ours(search_function *search,
                           const struct instance *instance, int threads,
                           struct answers *answers)
{
    int64_t start = clock_ns(), built = start;
    struct question question = {.points = instance->points,
                                .space.geometry = STANDARD,
                                .threads = threads,
                                .built_ns = &built};
    search(&question, answers);
    int64_t end = clock_ns();
    return (struct run){built - start, end - built};
}

static struct run run_peer(const struct peer *peer, int leaf_size,
                           const struct instance *instance, int threads,
                           struct answers *answers)
{
    int64_t start = clock_ns();
    void *built = peer->build((const place *)instance->place,
                              instance->points.n, leaf_size, threads);
    int64_t ready = clock_ns();
    peer->query(built, threads, answers->nearest, answers->nearest2);
    int64_t end = clock_ns();
    peer->discard(built);
    return (struct run){ready - start, end - ready};
}

// Where there are several trials, one more comes before them, untimed:
// then no program pays for being the first.
static struct times repeat(const struct program *program, int leaf_size,
                           const struct instance *instance, int threads,
                           int trials, struct answers *answers)
{
    double time[3][MAX_TRIALS];
    for (int trial = trials > 1 ? -1 : 0; trial < trials; trial++) {
        struct run run =
            program->search
                ? run_ours(program->search, instance, threads, answers)
                : run_peer(program->peer, leaf_size, instance, threads,
                           answers);
        if (trial < 0)
            continue;
        time[0][trial] = run.build;
        time[1][trial] = run.query;
        time[2][trial] = run.build + run.query;
    }
    return (struct times){summarize(time[0], trials),
                          summarize(time[1], trials),
                          summarize(time[2], trials)};
}

int best_leaf_size(const struct peer *peer,
                   const struct instance *instance,
                   struct answers *answers)
{
    int best = peer->leaf_size[0];
    double least = INFINITY;
    for (int k = 0; k < LEAVES; k++) {
        struct run run =
            run_peer(peer, peer->leaf_size[k], instance, 1, answers);
        if (run.build + run.query < least) {
            least = run.build + run.query;
            best = peer->leaf_size[k];
        }
    }
    return best;
}

// By the distances to the points that were named, computed here: the
// libraries may have rounded theirs differently, or been compiled to.
// Returns how many are not the same.
static uint32_t compare(const char *name,
                        const struct instance *instance,
                        const struct answers *answers)
{
    const struct points points = instance->points;
    uint32_t differ = 0;
    for (uint32_t i = 0; i < points.n; i++) {
        uint32_t j = answers->nearest[i];
        if (j >= points.n || j == i)
            fail("%s: %u is no neighbor of point %u", name, j, i);
        double found2 = distance2(points.x[j] - points.x[i],
                                  points.y[j] - points.y[i]);
        double right2 = instance->known ? instance->right2[i] : found2;
        if (fabs(found2 - right2) > rounding * right2 ||
            fabs(answers->nearest2[i] - found2) > rounding * found2)
            fail("%s: point %u has a neighbor at %.17g, and not at "
                 "%.17g, said to be %.17g (squared)",
                 name, i, right2, found2, answers->nearest2[i]);
        differ += found2 != right2;
        instance->right2[i] = right2;
    }
    return differ;
}

// Ten times as long, or if it was more than that the last time, so much
// again. The history holds least times: they are the steadiest.
static double expect(const struct history *history)
{
    double growth =
        history->before > 0 ? history->last / history->before : 10;
    return history->last * fmax(growth, 10);
}

struct result compete(const struct program *program, int leaf_size,
                      const struct rules *rules,
                      struct instance *instance,
                      struct answers *answers, struct history *history)
{
    const uint32_t n = instance->points.n;
    struct result result = {.expected = expect(history)};
    history->before = history->last;
    history->last = result.expected;
    if (result.expected > rules->limit * n)
        return result;
    result.trials =
        (int)fmin(rules->trials,
                  fmax(1, rules->patience / fmax(result.expected, 1)));
    result.one =
        repeat(program, leaf_size, instance, 1, result.trials, answers);
    history->last = result.one.total.min;
    result.threaded = result.trials > 1 &&
                      (program->search || program->peer->threaded);
    if (result.threaded)
        result.all = repeat(program, leaf_size, instance,
                            rules->threads, result.trials, answers);
    result.differ = compare(program->name, instance, answers);
    instance->known = true;
    return result;
}
