// Half the pairs: every version of the triangular loop against a plain
// search written here, with ties, with every schedule, with distances
// too large and too small for a double; and how much was measured.
#include "algorithms.h"
#include "ch03-half-pairs/best.h"
#include "ch03-half-pairs/guarded.h"
#include "ch03-half-pairs/private.h"
#include "ch03-half-pairs/triangle.h"
#include "ch03-half-pairs/triangle_tiles.h"
#include "common/generate.h"
#include "harness.h"
#include <stddef.h>

static const struct {
    const char *name;
    search_function *run;
} versions[] = {
    {"triangle", triangle},
    {"queue", triangle_locked},
    {"critical", triangle_critical},
    {"atomic", triangle_atomic},
    {"reduction", triangle_reduction},
    {"tiles", triangle_tiles},
};
enum { VERSIONS = sizeof versions / sizeof *versions };

static struct answers expected(const struct question *question)
{
    struct answers answers = answers_allocate(question->points.n);
    search_plainly(question, &answers);
    return answers;
}

// Reports the first wrong point only: the others would say no more.
static void check_answers(const struct answers *right,
                          const struct answers *found, uint32_t n,
                          const char *name, const char *points,
                          int threads)
{
    for (uint32_t i = 0; i < n; i++)
        if (!CHECK_INT(right->nearest[i], found->nearest[i],
                       "%s, %u %s points, %d threads: nearest of %u",
                       name, n, points, threads, i) ||
            !CHECK_INT(right->furthest[i], found->furthest[i],
                       "%s, %u %s points, %d threads: furthest of %u",
                       name, n, points, threads, i) ||
            !CHECK_DOUBLE(right->nearest2[i], found->nearest2[i],
                          "%s, %u %s points, %d threads: distance to "
                          "the nearest of %u",
                          name, n, points, threads, i) ||
            !CHECK_DOUBLE(right->furthest2[i], found->furthest2[i],
                          "%s, %u %s points, %d threads: distance to "
                          "the furthest of %u",
                          name, n, points, threads, i))
            return;
}

static void check_versions(struct points points, struct space space,
                           const char *name)
{
    struct question question = {points, space, 1};
    struct answers right = expected(&question);
    struct answers found = answers_allocate(points.n);
    for (int threads = 1; threads <= 4; threads *= 2)
        for (int v = 0; v < VERSIONS; v++) {
            if (versions[v].run == triangle_locked && points.n > 100)
                continue; // four queues a pair take their time
            question.threads = threads;
            versions[v].run(&question, &found);
            check_answers(&right, &found, points.n, versions[v].name,
                          name, threads);
        }
    answers_free(&found);
    answers_free(&right);
}

// Sizes around the edges of blocks and chunks.
static const uint32_t sizes[] = {2,  3,   7,   8,   31,  33,
                                 64, 255, 256, 257, 513, 700};
enum { SIZES = sizeof sizes / sizeof *sizes };

// The largest sizes take longer than all others: every third kind.
static void same_answers(void)
{
    for (int d = 0; d < distribution_count; d++)
        for (int s = 0; s < SIZES; s++) {
            if (sizes[s] > 500 && d % 3 != 0)
                continue;
            test_seed(s + 1);
            struct points points =
                generate(&distributions[d], sizes[s], s + 1);
            check_versions(points, (struct space){STANDARD, 1, 1},
                           distributions[d].name);
            points_free(&points);
        }
}

static void wraparound(void)
{
    for (int s = 0; s < SIZES; s++) {
        test_seed(s + 1);
        struct points points =
            generate(find_distribution("uniform"), sizes[s], s + 1);
        check_versions(points, (struct space){WRAPAROUND, 1, 1},
                       "wrapped");
        for (uint32_t i = 0; i < points.n; i++)
            points.y[i] *= 3;
        check_versions(points, (struct space){WRAPAROUND, 1, 3},
                       "wrapped, tall");
        points_free(&points);
    }
}

// Many points in few places: ties everywhere.
static void ties(void)
{
    struct points points = points_allocate(300);
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = i * 7 % 4 * 0.25;
        points.y[i] = i * 5 % 3 * 0.25;
    }
    check_versions(points, (struct space){STANDARD, 1, 1}, "tying");
    check_versions(points, (struct space){WRAPAROUND, 1, 1}, "tying");
    points_free(&points);
}

// Squares that overflow, and squares that vanish.
static void extremes(void)
{
    const double scales[] = {1e300, 1e-300};
    for (int s = 0; s < 2; s++)
        for (uint32_t n = 2; n <= 600; n = 2 * n + 1) {
            struct points points = points_allocate(n);
            for (uint32_t i = 0; i < n; i++) {
                points.x[i] = (i % 2 ? 1 : -1) * scales[s];
                points.y[i] = i % 5 * scales[s];
            }
            check_versions(points, (struct space){STANDARD, 1, 1},
                           s == 0 ? "huge" : "tiny");
            points_free(&points);
        }
}

static void schedules(void)
{
    const omp_sched_t kinds[] = {omp_sched_static, omp_sched_dynamic,
                                 omp_sched_guided};
    test_seed(5);
    struct points points =
        generate(find_distribution("lattice"), 400, 5);
    struct question question = {points, {STANDARD, 1, 1}, 3};
    struct answers right = expected(&question);
    struct answers found = answers_allocate(points.n);
    for (int kind = 0; kind < 3; kind++)
        for (int chunk = 0; chunk <= 512; chunk = chunk * 8 + 1) {
            triangle_private(&question, &found, kinds[kind], chunk);
            check_answers(&right, &found, points.n, "private",
                          kind == 0   ? "static"
                          : kind == 1 ? "dynamic"
                                      : "guided",
                          chunk);
        }
    answers_free(&found);
    answers_free(&right);
    points_free(&points);
}

static void half_the_distances(void)
{
    const char *exact[] = {"triangle", "triangle-critical",
                           "triangle-atomic", "triangle-reduction"};
    for (int s = 0; s < SIZES; s++) {
        uint64_t n = sizes[s];
        struct points points =
            generate(find_distribution("uniform"), n, s + 1);
        struct answers answers = answers_allocate(n);
        for (int threads = 1; threads <= 4; threads *= 2) {
            struct question question = {
                points, {STANDARD, 1, 1}, threads};
            for (int a = 0; a < 4; a++)
                CHECK_INT(n * (n - 1) / 2,
                          count_operations(find_algorithm(exact[a]),
                                           &question, &answers)
                              .distances,
                          "distances of %s, %u points, %d threads",
                          exact[a], (unsigned)n, threads);
        }
        answers_free(&answers);
        points_free(&points);
    }
}

// The tiles measure half the pairs, and look through two blocks of 256
// for every point; how far they look does not depend on the threads.
static void distances_of_tiles(void)
{
    const struct algorithm *tiles = find_algorithm("triangle-tiles");
    for (int s = 0; s < SIZES; s++) {
        uint64_t n = sizes[s];
        struct points points =
            generate(find_distribution("uniform"), n, s + 1);
        struct answers answers = answers_allocate(n);
        struct question question = {points, {STANDARD, 1, 1}, 1};
        uint64_t alone =
            count_operations(tiles, &question, &answers).distances;
        CHECK(alone >= n * (n - 1) / 2 + 2 * n &&
                  alone <= n * (n - 1) / 2 + 512 * n,
              "%llu distances for %u points", (unsigned long long)alone,
              (unsigned)n);
        question.threads = 3;
        CHECK_INT(
            alone,
            count_operations(tiles, &question, &answers).distances,
            "distances of %u points on 3 threads", (unsigned)n);
        answers_free(&answers);
        points_free(&points);
    }
}

// A row improves both ends and no others.
static void one_row(void)
{
    double x[] = {0, 4, 1, 7}, y[] = {0, 0, 0, 0};
    struct question question = {{4, x, y}, {STANDARD, 1, 1}, 1};
    struct answers answers = answers_allocate(4);
    triangle_begin(&answers, 4);
    triangle_row(&question, &answers, 1);
    CHECK_INT(2, answers.nearest[1], "nearest of point 1 after row 1");
    CHECK_DOUBLE(9, answers.nearest2[1], "its distance");
    CHECK_INT(1, answers.nearest[3], "nearest of point 3 after row 1");
    CHECK_DOUBLE(9, answers.furthest2[3], "its furthest distance");
    CHECK_DOUBLE(INFINITY, answers.nearest2[0], "point 0, untouched");
    CHECK_DOUBLE(0, answers.furthest2[0], "point 0, untouched");
    answers_free(&answers);
}

// Whoever comes first, the smaller key wins, then the lower index; and
// no offer is lost when many threads make them to one best.
static void offers(void)
{
    void (*const offer[])(struct best *, double, uint32_t) = {
        offer_locked, offer_critical, offer_atomic};
    const char *names[] = {"queue", "critical", "atomic"};
    for (int way = 0; way < 3; way++) {
        struct bests bests = bests_begin(1);
        struct best *best = bests.near;
#pragma omp parallel for num_threads(4) schedule(static, 1)
        for (uint32_t k = 0; k < 40000; k++)
            offer[way](best, 10000 - k / 4, 40000 - k);
        CHECK_DOUBLE(1, best->key, "the least key, %s", names[way]);
        CHECK_INT(1, best->index, "its lowest index, %s", names[way]);
        offer[way](best, INFINITY, 0);
        CHECK_INT(1, best->index, "after a worse offer, %s",
                  names[way]);
        offer[way](best, -INFINITY, 7);
        CHECK_INT(7, best->index, "after a better one, %s", names[way]);
        bests_free(&bests);
    }
}

int main(void)
{
    return RUN_TESTS("ch03-half-pairs", TEST(same_answers),
                     TEST(wraparound), TEST(ties), TEST(extremes),
                     TEST(schedules), TEST(half_the_distances),
                     TEST(distances_of_tiles), TEST(one_row),
                     TEST(offers));
}
