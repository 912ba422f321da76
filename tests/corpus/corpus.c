// Every algorithm of the table against the plainest search there is,
// on every kind of points that has ever made one fail. Distances must
// be the same to the last bit, and neighbors the same to the index:
// where several points tie, the lowest index is right.
#include "algorithms.h"
#include "common/generate.h"
#include "common/isa.h"
#include "common/random.h"
#include "harness.h"
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- what is right -------------------------------------------------
static bool same_kind(const char *what, const char *kind, uint32_t n,
                      const uint32_t *right, const double *right2,
                      const uint32_t *found, const double *found2)
{
    for (uint32_t i = 0; i < n; i++)
        if (!CHECK_DOUBLE(right2[i], found2[i],
                          "%s: squared %s distance of point %" PRIu32,
                          what, kind, i) ||
            !CHECK_INT(right[i], found[i],
                       "%s: %s neighbor of point %" PRIu32, what, kind,
                       i))
            return false; // one is enough to go by
    return true;
}

// ---- one algorithm, one question -----------------------------------
static const char *geometry_of(const struct question *question)
{
    return question->space.geometry == STANDARD ? "standard"
                                                : "wraparound";
}

static void soil(void *array, size_t size)
{
    if (array)
        memset(array, 0xA5, size);
}

// Arrays that the algorithm is not to touch are not even there.
static struct answers make_room(uint32_t n, unsigned given)
{
    struct answers answers = answers_for(n, given);
    soil(answers.nearest, n * sizeof *answers.nearest);
    soil(answers.furthest, n * sizeof *answers.furthest);
    soil(answers.nearest2, n * sizeof *answers.nearest2);
    soil(answers.furthest2, n * sizeof *answers.furthest2);
    return answers;
}

static void compare(const char *what, const struct question *question,
                    const struct answers *right,
                    const struct answers *found)
{
    uint32_t n = question->points.n;
    if (found->nearest && right->nearest)
        same_kind(what, "nearest", n, right->nearest, right->nearest2,
                  found->nearest, found->nearest2);
    if (found->furthest && right->furthest)
        same_kind(what, "furthest", n, right->furthest,
                  right->furthest2, found->furthest, found->furthest2);
}

// Instruction sets take turns, those that the machine has: all of them
// on all points, and each with any number of threads, would take long.
static const char *take_instructions(uint64_t turn)
{
    enum isa isa = turn % ISA_COUNT;
    while (!isa_present(isa))
        isa--;
    setenv("NEAR_ISA", isa_names[isa], 1);
    return isa_names[isa];
}

static void try_row(const struct algorithm *row, const char *points,
                    const struct question *question, const char *isa,
                    const struct answers *right)
{
    char what[200];
    snprintf(what, sizeof what,
             "%s, %s, %s, %" PRIu32 " points, %s, threads %d",
             row->name, isa, points, question->points.n,
             geometry_of(question), question->threads);
    struct answers found = make_room(question->points.n, row->answers);
    row->run(question, &found);
    compare(what, question, right, &found);
    answers_free(&found);
}

// So many points are not counted twice: it would take half the time.
enum { THOUSANDS = 1000 };

// Nor are rows of n^2 steps asked for more.
static bool is_wanted(const struct algorithm *row,
                      const struct question *question)
{
    return row->geometries & question->space.geometry &&
           (question->points.n <= THOUSANDS || !strchr(row->cost, '^'));
}

static void count_row(const struct algorithm *row, const char *points,
                      const struct question *question,
                      const struct answers *right)
{
    const uint32_t n = question->points.n;
    char what[200];
    snprintf(what, sizeof what,
             "%s, counting, %s, %" PRIu32 " points, %s", row->name,
             points, n, geometry_of(question));
    struct answers found = make_room(n, row->answers);
    uint64_t counted =
        count_operations(row, question, &found).distances;
    compare(what, question, right, &found);
    CHECK(counted > 0, "%s: distances", what);
    if (n < THOUSANDS)
        CHECK_INT((long long)counted,
                  (long long)count_operations(row, question, &found)
                      .distances,
                  "%s: distances counted again", what);
    answers_free(&found);
}

// ---- every algorithm, one set of points ----------------------------
static struct points copy_of(struct points points)
{
    struct points copy = points_allocate(points.n);
    memcpy(copy.x, points.x, points.n * sizeof *points.x);
    memcpy(copy.y, points.y, points.n * sizeof *points.y);
    return copy;
}

// The unit square if it holds the points, else a box that just does.
static struct space wrap_around(struct points points)
{
    double x0 = 0, y0 = 0, x1 = 1, y1 = 1;
    for (uint32_t i = 0; i < points.n; i++) {
        x0 = fmin(x0, points.x[i]), x1 = fmax(x1, points.x[i]);
        y0 = fmin(y0, points.y[i]), y1 = fmax(y1, points.y[i]);
    }
    return (struct space){WRAPAROUND, x1 - x0, y1 - y0};
}

static void try_space(const char *name, struct points points,
                      struct space space)
{
    struct points before = copy_of(points);
    struct question question = {points, space, 1};
    struct answers right = answers_allocate(points.n);
    search_plainly(&question, &right);
    for (int row = 0; row < algorithm_count; row++)
        if (is_wanted(&algorithms[row], &question))
            count_row(&algorithms[row], name, &question, &right);
    // Another number of threads means new threads: not at each row.
    static uint64_t sets;
    for (int k = 0; k < 3; k++) {
        question.threads = 1 << k;
        for (int row = 0; row < algorithm_count; row++)
            if (is_wanted(&algorithms[row], &question))
                try_row(&algorithms[row], name, &question,
                        take_instructions(sets + k + row), &right);
    }
    sets++;
    size_t size = points.n * sizeof *points.x;
    CHECK(memcmp(before.x, points.x, size) == 0 &&
              memcmp(before.y, points.y, size) == 0,
          "%s: the points are left as they were", name);
    answers_free(&right);
    points_free(&before);
}

// No box holds points that are further apart than the largest number.
static void try_points(const char *name, struct points points)
{
    struct space box = wrap_around(points);
    try_space(name, points, (struct space){STANDARD, 1, 1});
    if (isfinite(box.width) && isfinite(box.height))
        try_space(name, points, box);
}

// ---- the points ----------------------------------------------------
static void table_is_complete(void)
{
    CHECK(algorithm_count > 0, "the table has rows");
    for (int row = 0; row < algorithm_count; row++) {
        const struct algorithm *a = &algorithms[row];
        CHECK(find_algorithm(a->name) == a, "%s: its name is its own",
              a->name);
        CHECK(a->chapter >= 2, "%s: chapter", a->name);
        CHECK(a->geometries && a->geometries <= 3, "%s: geometries",
              a->name);
        CHECK(a->answers && a->answers <= 3, "%s: answers", a->name);
        CHECK(*a->cost && *a->about, "%s: description", a->name);
    }
    CHECK(!find_algorithm("oracle"), "a name that is not there");
}

// Around the lengths of vectors, tiles and blocks.
static void uniform_of_every_length(void)
{
    static const uint32_t lengths[] = {
        2,  3,  4,  5,  6,  7,  8,   9,   15,  16,  17,  31,
        32, 33, 63, 64, 65, 99, 100, 127, 129, 255, 256, 257};
    const struct distribution *uniform = find_distribution("uniform");
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) {
        test_seed(k);
        struct points points = generate(uniform, lengths[k], k);
        try_points("uniform", points);
        points_free(&points);
    }
}

static void every_generator(void)
{
    static const uint32_t lengths[] = {2, 3, 16, 33, 100, 500};
    const uint32_t most = at_most("MOST_POINTS", 500 * 20) / 20;
    for (int d = 0; d < distribution_count; d++)
        for (size_t k = 0;
             k < sizeof lengths / sizeof *lengths && lengths[k] <= most;
             k++) {
            test_seed(k);
            struct points points =
                generate(&distributions[d], lengths[k], k);
            try_points(distributions[d].name, points);
            points_free(&points);
        }
}

static void thousands_of_points(void)
{
    uint32_t most = at_most("MOST_POINTS", 20 * THOUSANDS) / 10;
    for (int d = 0; d < distribution_count; d++)
        for (uint32_t n = THOUSANDS; n <= most; n += THOUSANDS) {
            test_seed(7);
            struct points points = generate(&distributions[d], n, 7);
            try_points(distributions[d].name, points);
            points_free(&points);
        }
}

// A point drawn from a coarse grid that reaches both borders: few
// different distances, many duplicates, ties everywhere.
static void ties_on_a_coarse_grid(void)
{
    for (uint64_t seed = 0; seed < 100; seed++) {
        test_seed(seed);
        struct random random = {seed};
        uint32_t n = 2 + random_bits(&random) % 40;
        int steps = 1 << random_bits(&random) % 4;
        struct points points = points_allocate(n);
        for (uint32_t i = 0; i < n; i++) {
            points.x[i] =
                (double)(random_bits(&random) % (steps + 1)) / steps;
            points.y[i] =
                (double)(random_bits(&random) % (steps + 1)) / steps;
        }
        try_points("coarse grid", points);
        points_free(&points);
    }
}

// ---- a hundred thousand small cases --------------------------------
// Up to 40 points, few different coordinates on either axis, not all of
// them exact in binary; here and there an outlier.
static struct points draw_case(uint64_t seed)
{
    struct random random = {seed};
    struct points p = points_allocate(2 + random_bits(&random) % 39);
    int columns = 1 + random_bits(&random) % 9;
    int rows = 1 + random_bits(&random) % 9;
    double step = random_bits(&random) % 2 ? 0.125 : 0.1;
    for (uint32_t i = 0; i < p.n; i++) {
        p.x[i] = (double)(random_bits(&random) % columns) * step;
        p.y[i] = (double)(random_bits(&random) % rows) * step;
    }
    if (random_bits(&random) % 8 == 0)
        p.x[random_bits(&random) % p.n] = 1;
    if (random_bits(&random) % 8 == 0)
        p.y[random_bits(&random) % p.n] = 1;
    return p;
}

static bool same_bits(const void *right, const void *found, size_t size)
{
    return !found || memcmp(right, found, size) == 0;
}

static void try_case(const struct algorithm *row,
                     const struct question *question,
                     const struct answers *right)
{
    uint32_t n = question->points.n;
    struct answers found = make_room(n, row->answers);
    row->run(question, &found);
    size_t indices = n * sizeof *right->nearest;
    size_t distances = n * sizeof *right->nearest2;
    if (!same_bits(right->nearest, found.nearest, indices) ||
        !same_bits(right->furthest, found.furthest, indices) ||
        !same_bits(right->nearest2, found.nearest2, distances) ||
        !same_bits(right->furthest2, found.furthest2, distances)) {
        CHECK(false, "%s, %s: the same bits", row->name,
              getenv("NEAR_ISA"));
        compare(row->name, question, right, &found);
    }
    answers_free(&found);
}

static void many_small_cases(void)
{
    uint32_t cases = at_most("MOST_CASES", 100000);
    for (uint64_t seed = 0; seed < cases; seed++) {
        test_seed(seed);
        take_instructions(seed);
        struct points points = draw_case(seed);
        struct answers right = answers_allocate(points.n);
        for (int g = STANDARD; g <= WRAPAROUND; g++) {
            struct question question = {points, {g, 1, 1}, 1};
            search_plainly(&question, &right);
            for (int row = 0; row < algorithm_count; row++)
                if (algorithms[row].geometries & g)
                    try_case(&algorithms[row], &question, &right);
        }
        answers_free(&right);
        points_free(&points);
    }
}

// ---- as many points as the linear searches like --------------------
// The plainest search would take too long here: the rows of a cost
// below n^2 are held against each other, near and far, and with fewer
// points against the tiles. So would points that crowd in few cells.
static void many_points(uint32_t n, const struct algorithm *judge)
{
    static const char *const names[] = {"uniform", "clustered",
                                        "lattice"};
    for (int d = 0; d < 3; d++)
        for (int g = STANDARD; g <= WRAPAROUND; g++) {
            struct points points =
                generate(find_distribution(names[d]), n, 9);
            struct question question = {points, wrap_around(points), 2};
            question.space.geometry = g;
            struct answers right = make_room(n, judge->answers);
            judge->run(&question, &right);
            for (int row = 0; row < algorithm_count; row++) {
                const struct algorithm *a = &algorithms[row];
                if (a == judge || strchr(a->cost, '^') ||
                    !(a->geometries & g) ||
                    !(a->answers & judge->answers))
                    continue;
                struct answers found = make_room(n, a->answers);
                char what[100];
                snprintf(what, sizeof what,
                         "%s, %s, %" PRIu32 " %s points", a->name,
                         take_instructions(d + g + row), n, names[d]);
                a->run(&question, &found);
                compare(what, &question, &right, &found);
                answers_free(&found);
            }
            answers_free(&right);
            points_free(&points);
        }
}

static void against_tiles(void)
{
    many_points(at_most("MOST_POINTS", 10000), find_algorithm("tiles"));
}

static void against_each_other(void)
{
    uint32_t n = at_most("MOST_POINTS", 200000);
    many_points(n, find_algorithm("cells-lists"));
    many_points(n, find_algorithm("furthest-cells"));
}

static void points_on_the_borders(void)
{
    struct random random = {1};
    test_seed(1);
    struct points points = points_allocate(200);
    for (uint32_t i = 0; i < points.n; i++) {
        double along = random_uniform(&random);
        points.x[i] = i % 4 < 2 ? i % 2 : along;
        points.y[i] = i % 4 < 2 ? along : i % 2;
    }
    for (uint32_t i = 0; i < 4; i++) { // and in the corners
        points.x[50 * i] = i % 2;
        points.y[50 * i] = i / 2;
    }
    try_points("borders", points);
    points_free(&points);
}

static void every_point_twice(void)
{
    test_seed(3);
    struct points points =
        generate(find_distribution("uniform"), 300, 3);
    for (uint32_t i = 0; i < points.n / 2; i++) {
        points.x[points.n - 1 - i] = points.x[i];
        points.y[points.n - 1 - i] = points.y[i];
    }
    try_points("twice", points);
    points_free(&points);
}

// Where squares are infinite, or nothing: all distances tie, and every
// point still has a neighbor. In the end even differences are infinite.
static void extreme_coordinates(void)
{
    static const double scales[] = {1e-320, 1e-300, 1e-160,
                                    1e-154, 1e150,  1e154,
                                    1e160,  1e300,  1.7e308};
    for (size_t k = 0; k < sizeof scales / sizeof *scales; k++) {
        test_seed(k);
        struct points points =
            generate(find_distribution("uniform"), 70, k);
        char name[40];
        snprintf(name, sizeof name, "uniform times %g", scales[k]);
        for (uint32_t i = 0; i < points.n; i++) {
            points.x[i] = scales[k] * (2 * points.x[i] - 1);
            points.y[i] = scales[k] * (2 * points.y[i] - 1);
        }
        try_points(name, points);
        points_free(&points);
    }
}

// A few points far out of a crowd, and signed zeros in it.
static void outliers_and_zeros(void)
{
    test_seed(5);
    struct points points =
        generate(find_distribution("uniform"), 130, 5);
    points.x[0] = -1e300;
    points.y[17] = 1e300;
    points.x[64] = 1e8;
    points.x[65] = -0.0, points.y[65] = 0.0;
    points.x[129] = 0.0, points.y[129] = -0.0;
    try_points("outliers", points);
    points_free(&points);
}

int main(void)
{
    return RUN_TESTS("corpus", TEST(table_is_complete),
                     TEST(uniform_of_every_length),
                     TEST(every_generator), TEST(thousands_of_points),
                     TEST(ties_on_a_coarse_grid),
                     TEST(points_on_the_borders),
                     TEST(every_point_twice), TEST(extreme_coordinates),
                     TEST(outliers_and_zeros), TEST(many_small_cases),
                     TEST(against_tiles), TEST(against_each_other));
}
