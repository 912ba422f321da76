// Chapter 2: every version of the search gives the plain one's answers,
// to the last bit and the lowest index, and 100,000 points have the
// mean distances that the coursework reports.
#include "algorithms.h"
#include "ch02-all-pairs/experiments/choices.h"
#include "ch02-all-pairs/experiments/peak.h"
#include "ch02-all-pairs/first.h"
#include "ch02-all-pairs/ladder.h"
#include "ch02-all-pairs/naive.h"
#include "ch02-all-pairs/tile.h"
#include "ch02-all-pairs/tiles.h"
#include "common/generate.h"
#include "common/random.h"
#include "harness.h"
#include <inttypes.h>
#include <omp.h>
#include <stddef.h>

// ---- the same answers ----------------------------------------------
static bool same_answers(const char *what, const struct answers *right,
                         const struct answers *found, uint32_t begin,
                         uint32_t end)
{
    for (uint32_t i = begin; i < end; i++)
        if (!CHECK_DOUBLE(right->nearest2[i], found->nearest2[i],
                          "%s: nearest distance of %" PRIu32, what,
                          i) ||
            !CHECK_DOUBLE(right->furthest2[i], found->furthest2[i],
                          "%s: furthest distance of %" PRIu32, what,
                          i) ||
            !CHECK_INT(right->nearest[i], found->nearest[i],
                       "%s: nearest of %" PRIu32, what, i) ||
            !CHECK_INT(right->furthest[i], found->furthest[i],
                       "%s: furthest of %" PRIu32, what, i))
            return false;
    return true;
}

// Rows that were not asked for are not touched.
static void stays_within(const char *what, rows_function *rows,
                         const struct question *question,
                         struct answers *found, uint32_t begin,
                         uint32_t end)
{
    const uint32_t n = question->points.n;
    for (uint32_t i = 0; i < n; i++) {
        found->nearest[i] = found->furthest[i] = n;
        found->nearest2[i] = found->furthest2[i] = -1;
    }
    rows(question, found, begin, end);
    uint32_t touched = 0;
    for (uint32_t i = 0; i < n; i++)
        touched += found->nearest[i] != n || found->furthest[i] != n ||
                   found->nearest2[i] != -1 ||
                   found->furthest2[i] != -1;
    CHECK_INT(end - begin, touched, "%s: rows touched", what);
}

// All versions, on the whole and on some rows in the middle.
static void compare(const struct question *question)
{
    const uint32_t n = question->points.n;
    struct answers right = answers_allocate(n);
    struct answers found = answers_allocate(n);
    naive(question, &right);
    for (int step = 0; step < step_count; step++) {
        steps[step].rows(question, &found, 0, n);
        same_answers(steps[step].name, &right, &found, 0, n);
        uint32_t begin = n / 2 / LANES * LANES;
        uint32_t end = begin + (n - begin) / 2;
        steps[step].rows(question, &found, begin, end);
        same_answers(steps[step].name, &right, &found, begin, end);
        stays_within(steps[step].name, steps[step].rows, question,
                     &found, begin, end);
    }
    for (uint32_t block = LANES; block <= 4 * LANES; block *= 2) {
        tiles_blocked_rows(question, &found, 0, n, block);
        same_answers("tiles in small blocks", &right, &found, 0, n);
    }
    for (int threads = 1; threads <= 4; threads *= 2) {
        struct question shared = *question;
        shared.threads = threads;
        tiles(&shared, &found);
        same_answers("tiles", &right, &found, 0, n);
        naive(&shared, &found);
        same_answers("naive", &right, &found, 0, n);
    }
    answers_free(&right);
    answers_free(&found);
}

static void compare_in_both(struct points points, double width,
                            double height)
{
    compare(&(struct question){points, {STANDARD, 0, 0}, 1});
    compare(&(struct question){points, {WRAPAROUND, width, height}, 1});
}

static void every_step_agrees(void)
{
    // Around the lengths of a tile and of a block.
    static const uint32_t sizes[] = {
        2,         3,     LANES - 1, LANES,     LANES + 1,     17,
        BLOCK - 1, BLOCK, BLOCK + 1, BLOCK + 8, 2 * BLOCK + 3, 1000};
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++)
        for (uint64_t seed = 1; seed <= (sizes[s] > BLOCK ? 1 : 3);
             seed++) {
            test_seed(seed);
            struct points points =
                generate(find_distribution("uniform"), sizes[s], seed);
            compare_in_both(points, 1, 1);
            points_free(&points);
        }
}

// Few different coordinates: ties everywhere, duplicates as well.
static void ties_go_to_the_lowest_index(void)
{
    for (uint64_t seed = 1; seed <= 3; seed++) {
        test_seed(seed);
        struct random random = {seed};
        struct points points = points_allocate(BLOCK + 50);
        for (uint32_t i = 0; i < points.n; i++) {
            points.x[i] = random_bits(&random) % 5 * 0.25;
            points.y[i] = random_bits(&random) % 5 * 0.5;
        }
        compare_in_both(points, 1, 2);
        points_free(&points);
    }
}

static void all_equal_points_have_neighbors(void)
{
    struct points points = points_allocate(BLOCK + LANES + 1);
    for (uint32_t i = 0; i < points.n; i++)
        points.x[i] = points.y[i] = 0.5;
    compare_in_both(points, 1, 1);

    struct answers found = answers_allocate(points.n);
    struct question question = {points, {STANDARD, 0, 0}, 1};
    tiles(&question, &found);
    CHECK_INT(1, found.nearest[0], "the first point's neighbor");
    CHECK_INT(0, found.nearest[points.n - 1], "the last point's");
    CHECK_DOUBLE(0, found.furthest2[0], "nothing is further");
    answers_free(&found);
    points_free(&points);
}

// Squares that overflow to infinity and underflow to zero.
static void extreme_coordinates_have_neighbors(void)
{
    static const double scales[] = {1e300, 1e-300, 1e154, 1e-162};
    for (int s = 0; s < 4; s++) {
        struct random random = {s + 1};
        test_seed(s + 1);
        struct points points = points_allocate(BLOCK + 13);
        for (uint32_t i = 0; i < points.n; i++) {
            points.x[i] = random_uniform(&random) * scales[s];
            points.y[i] = random_uniform(&random) * scales[s];
        }
        compare_in_both(points, scales[s], scales[s]);
        points_free(&points);
    }
    struct points points = points_allocate(2);
    points.x[0] = points.y[0] = -1e300;
    points.x[1] = points.y[1] = 1e300;
    compare(&(struct question){points, {STANDARD, 0, 0}, 1});
    struct answers found = answers_allocate(2);
    tiles(&(struct question){points, {STANDARD, 0, 0}, 1}, &found);
    CHECK_DOUBLE(INFINITY, found.nearest2[0], "too far to square");
    CHECK_INT(1, found.nearest[0], "and still a neighbor");
    CHECK_INT(0, found.furthest[1], "in both directions");
    answers_free(&found);
    points_free(&points);
}

// ---- the experiments' own functions --------------------------------
static void every_way_to_square_agrees(void)
{
    test_seed(7);
    struct random random = {7};
    for (int k = 0; k < 1000; k++) {
        double dx = random_normal(&random), dy = random_normal(&random);
        double times[2], power[2], hidden[2];
        struct space space = {STANDARD, 0, 0};
        measure_standard(&space, dx, dy, times);
        measure_pow(&space, dx, dy, power);
        measure_pow_variable(&space, dx, dy, hidden);
        CHECK_DOUBLE(times[0], power[0], "pow(dx, 2.0)");
        CHECK_NEAR(times[1], hidden[1], 4e-16 * times[1],
                   "pow with a hidden exponent");
    }
}

static void every_choice_agrees(void)
{
    rows_function *plain[] = {pointer_rows, flag_rows, copies_rows};
    rows_function *lanes[] = {pointer_lanes_rows, flag_lanes_rows,
                              copies_lanes_rows};
    test_seed(5);
    const uint32_t n = 320;
    struct points points = generate(find_distribution("uniform"), n, 5);
    struct answers right = answers_allocate(n);
    struct answers found = answers_allocate(n);
    for (int g = STANDARD; g <= WRAPAROUND; g++) {
        struct question question = {points, {g, 1, 1}, 1};
        naive(&question, &right);
        for (int way = 0; way < 3; way++) {
            plain[way](&question, &found, 0, n);
            for (uint32_t i = 0; i < n; i++) {
                CHECK_DOUBLE(right.nearest2[i], found.nearest2[i],
                             "nearest, way %d", way);
                CHECK_DOUBLE(right.furthest2[i], found.furthest2[i],
                             "furthest, way %d", way);
            }
            lanes[way](&question, &found, 0, n);
            // A point is its own candidate there.
            double self2 =
                g == STANDARD ? 0 : furthest2(question.space, 0, 0);
            for (uint32_t i = 0; i < n; i++) {
                CHECK_DOUBLE(0, found.nearest2[i], "lanes, way %d",
                             way);
                CHECK_DOUBLE(fmax(self2, right.furthest2[i]),
                             found.furthest2[i],
                             "furthest by lanes, way %d", way);
            }
        }
    }
    answers_free(&right);
    answers_free(&found);
    points_free(&points);
}

static void limits_add_up(void)
{
    // Adders also take minima; multipliers are their own.
    double ns[PEAKS] = {[ADD] = 1,
                        [MULTIPLY] = 1,
                        [MINIMUM] = 1,
                        [FUSED] = 1,
                        [ADD_MULTIPLY] = 0.5,
                        [ADD_MINIMUM] = 1,
                        [MULTIPLY_MINIMUM] = 0.5,
                        [ALL] = 2.0 / 3};
    const struct bill plain = {3, 2, 0, 2}, handed = {1, 2, 2, 2};
    CHECK_DOUBLE(5, peak_limit(ns, plain), "five for the adders");
    CHECK_DOUBLE(4, peak_limit(ns, handed), "four to multiply");
    ns[FUSED] = 1.5;
    CHECK_DOUBLE(5, peak_limit(ns, handed), "two of them slower");
    ns[FUSED] = ns[ADD_MULTIPLY] = ns[MULTIPLY_MINIMUM] = ns[ALL] = 1;
    CHECK_DOUBLE(7, peak_limit(ns, plain), "all units are alike");
    // Minima, too, are taken by units of their own.
    ns[ADD_MULTIPLY] = ns[ADD_MINIMUM] = ns[MULTIPLY_MINIMUM] = 0.5;
    ns[ALL] = 1.0 / 3;
    CHECK_DOUBLE(3, peak_limit(ns, plain), "three additions");
    ns[ALL] = 0.5; // but only two operations can begin at once
    CHECK_DOUBLE(3.5, peak_limit(ns, plain), "seven in pairs");
}

// ---- counts and means ----------------------------------------------
static void count_distances(const struct algorithm *plain,
                            const struct algorithm *fast, uint32_t n,
                            int threads)
{
    struct points points = generate(find_distribution("uniform"), n, 1);
    struct answers answers = answers_allocate(n);
    struct question question = {points, {STANDARD, 0, 0}, threads};
    long long pairs = (long long)n * (n - 1);
    CHECK_INT(pairs,
              count_operations(plain, &question, &answers).distances,
              "every pair of %u points from both ends, %d threads",
              (unsigned)n, threads);
    // The spare lanes of a last tile meet all points before it, and
    // each point looks into two blocks again.
    long long width = n % LANES;
    long long spare = width ? (LANES - width) * (n - width) : 0;
    long long found =
        count_operations(fast, &question, &answers).distances;
    CHECK(spare < 8LL * n && found >= pairs + spare + 2 * n &&
              found <= pairs + spare + 512LL * n,
          "%lld distances of %u points on %d threads", found,
          (unsigned)n, threads);
    answers_free(&answers);
    points_free(&points);
}

static void distances_are_counted(void)
{
    const struct algorithm *plain = find_algorithm("naive");
    const struct algorithm *fast = find_algorithm("tiles");
    if (!CHECK(plain && fast, "both are in the table"))
        return;
    // Full last tiles and others, fewer points than lanes, than blocks.
    static const uint32_t sizes[] = {2, 7, 8, 9, 64, 255, 1003, 1008};
    for (int s = 0; s < 8; s++)
        for (int threads = 1; threads <= 2; threads++)
            count_distances(plain, fast, sizes[s], threads);
}

// The mean nearest distance of one set of points scatters by a sixth
// of a percent, and more if not every point is asked.
static void means_are_the_courseworks(void)
{
    static const double reported[2][2] = {{0.00158207, 1.067968},
                                          {0.00158203, 1.412812}};
    const uint32_t n = 100000, most = at_most("MOST_POINTS", n);
    const uint32_t rows = most == n ? n : most / 10;
    const double tolerance = 0.003 * sqrt((double)n / rows);
    test_seed(4);
    struct points points = generate(find_distribution("uniform"), n, 4);
    struct answers answers = answers_allocate(n);
    for (int g = 0; g < 2; g++) {
        struct question question = {points,
                                    {g ? WRAPAROUND : STANDARD, 1, 1},
                                    omp_get_num_procs()};
        if (rows == n)
            tiles(&question, &answers);
        else
            tiles_rows(&question, &answers, 0, rows);
        double nearest = 0, furthest = 0;
        for (uint32_t i = 0; i < rows; i++) {
            nearest += sqrt(answers.nearest2[i]) / rows;
            furthest += sqrt(answers.furthest2[i]) / rows;
        }
        CHECK_NEAR(reported[g][0], nearest, tolerance * reported[g][0],
                   "mean nearest distance, geometry %d", g);
        CHECK_NEAR(reported[g][1], furthest, tolerance * reported[g][1],
                   "mean furthest distance, geometry %d", g);
    }
    answers_free(&answers);
    points_free(&points);
}

int main(void)
{
    return RUN_TESTS("ch02-all-pairs", TEST(every_step_agrees),
                     TEST(ties_go_to_the_lowest_index),
                     TEST(all_equal_points_have_neighbors),
                     TEST(extreme_coordinates_have_neighbors),
                     TEST(every_way_to_square_agrees),
                     TEST(every_choice_agrees), TEST(limits_add_up),
                     TEST(distances_are_counted),
                     TEST(means_are_the_courseworks));
}
