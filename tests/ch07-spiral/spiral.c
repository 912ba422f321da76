// Spirals: ranges have every cell once and leave out none that matters;
// the search against the plainest there is, for any number of points to
// a cell; and as many distances as were expected.
#include "ch07-spiral/spiral.h"
#include "algorithms.h"
#include "ch07-spiral/experiments/census.h"
#include "ch07-spiral/experiments/expected.h"
#include "ch07-spiral/spiral_search.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/random.h"
#include "harness.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- ranges --------------------------------------------------------
// An axis of m cells from 0 to 1, with or without wraparound.
static struct axis unit_axis(enum geometry geometry, uint32_t m)
{
    return axis_cut(0, 1, geometry == STANDARD ? INFINITY : 1, m);
}

static void every_cell_once(void)
{
    for (int g = STANDARD; g <= WRAPAROUND; g++)
        for (uint32_t m = 1; m <= 9; m++) {
            struct axis axis = unit_axis(g, m);
            for (uint32_t cell = 0; cell < m; cell++) {
                struct search_range all = whole_range(&axis, cell);
                int times[9] = {0};
                for (int32_t d = -all.back; d <= all.ahead; d++)
                    times[step(&axis, cell, d)]++;
                for (uint32_t k = 0; k < m; k++)
                    CHECK_INT(1, times[k],
                              "geometry %d, %u cells: times that %u "
                              "sees %u",
                              g, m, cell, k);
            }
            axis_free(&axis);
        }
}

// How far x is from cell `to` along the axis, at least, by trying both
// of the cell's ends both ways.
static double plain_gap(const struct axis *axis, uint32_t to, double x)
{
    double low = axis->border[to], high = axis->border[to + 1];
    if (x >= low && x <= high)
        return 0;
    double direct = fmin(fabs(x - low), fabs(x - high));
    double around = axis->period - fmax(fabs(x - low), fabs(x - high));
    return fmin(direct, around);
}

static void check_view(enum geometry geometry, const struct axis *axis,
                       double x, double best2)
{
    uint32_t cell = axis_cell(axis, x);
    struct search_range all = whole_range(axis, cell);
    struct search_range view =
        geometry == STANDARD
            ? square_range(STANDARD, axis, all, cell, x, best2)
            : square_range(WRAPAROUND, axis, all, cell, x, best2);
    double slack = 1e-12;
    for (int32_t d = -all.back; d <= all.ahead; d++) {
        double gap = plain_gap(axis, step(axis, cell, d), x);
        bool in = d >= -view.back && d <= view.ahead;
        if (gap < sqrt(best2) - slack)
            CHECK(in, "geometry %d, %u cells, x %g, D %g: sees %d",
                  geometry, axis->count, x, sqrt(best2), d);
        // The cell opposite can be as near the other way round.
        bool opposite = geometry == WRAPAROUND &&
                        (d == -all.back || d == all.ahead);
        if (gap > sqrt(best2) + slack && !opposite && sqrt(best2) < 0.4)
            CHECK(!in,
                  "geometry %d, %u cells, x %g, D %g: does not see %d",
                  geometry, axis->count, x, sqrt(best2), d);
    }
}

static void views_of_squares(void)
{
    struct random random = {1};
    test_seed(1);
    for (int g = STANDARD; g <= WRAPAROUND; g++)
        for (uint32_t m = 1; m <= 40; m++) {
            struct axis axis = unit_axis(g, m);
            for (int k = 0; k < 500; k++) {
                double x = random_uniform(&random);
                double d = random_uniform(&random);
                check_view(g, &axis, x, d * d / (1 + k % 20));
            }
            axis_free(&axis);
        }
}

// A square that ends on a border sees the cells beyond: a tie may lie
// there.
static void squares_are_closed(void)
{
    struct axis axis = unit_axis(STANDARD, 4);
    struct search_range all = whole_range(&axis, 1);
    struct search_range view =
        square_range(STANDARD, &axis, all, 1, 0.375, 0.125 * 0.125);
    CHECK_INT(1, view.back, "to a border below");
    CHECK_INT(1, view.ahead, "to a border above");
    view = square_range(STANDARD, &axis, all, 1, 0.375,
                        nextafter(0.125 * 0.125, 0));
    CHECK_INT(0, view.back, "not quite to a border below");
    CHECK_INT(0, view.ahead, "not quite to a border above");
    view = square_range(STANDARD, &axis, all, 1, 0.25, 0);
    CHECK_INT(1, view.back, "from a point on the border");
    CHECK_INT(0, view.ahead, "away from the border");
    axis_free(&axis);
}

// ---- one search ----------------------------------------------------
enum { MOST_CELLS = 4096 };

struct recorder {
    struct spiral_query query; // first: a pointer to it is one to all
    int count;
    uint32_t cell[MOST_CELLS];
};

INLINED void visit_and_record(const enum geometry geometry,
                              const struct map *map, uint32_t cell,
                              struct spiral_query *query)
{
    struct recorder *recorder = (struct recorder *)query;
    recorder->cell[recorder->count++ % MOST_CELLS] = cell;
    visit_cell(geometry, map, cell, query);
}

static uint32_t steps_between(const struct axis *axis, uint32_t a,
                              uint32_t b)
{
    uint32_t steps = a > b ? a - b : b - a;
    uint32_t other = axis->count - steps;
    return axis->period != INFINITY && other < steps ? other : steps;
}

// No cell twice, and never a layer further in.
static void check_walk(const struct grid *grid,
                       const struct recorder *r, const char *what)
{
    uint32_t m = grid->x.count, last = 0, home = r->cell[0];
    bool seen[MOST_CELLS] = {false};
    CHECK_INT(r->count, (long long)r->query.cells,
              "%s: cells looked at", what);
    for (int k = 0; k < r->count; k++) {
        uint32_t cell = r->cell[k];
        CHECK(!seen[cell], "%s: cell %u is looked at once", what, cell);
        seen[cell] = true;
        uint32_t dx = steps_between(&grid->x, cell % m, home % m);
        uint32_t dy = steps_between(&grid->y, cell / m, home / m);
        uint32_t layer = dx > dy ? dx : dy;
        CHECK(layer >= last, "%s: layer %u after layer %u", what, layer,
              last);
        last = layer;
    }
}

static void out_in_layers(void)
{
    static const uint32_t lengths[] = {2, 5, 20, 60, 200};
    static struct recorder recorder;
    char what[100];
    for (int g = STANDARD; g <= WRAPAROUND; g++)
        for (int k = 0; k < 5; k++) {
            uint32_t n = lengths[k];
            test_seed(n);
            struct points points =
                generate(find_distribution("uniform"), n, n);
            struct question question = {points, {g, 1, 1}, 1};
            struct grid grid = grid_fit(&question, 0.1);
            struct cells cells = cells_sort(&grid, points);
            struct map map = {&grid, &cells, points, question.space};
            for (uint32_t i = 0; i < n; i++) {
                recorder.query = spiral_query_at(&map, i);
                recorder.count = 0;
                if (g == STANDARD)
                    spiral_nearest(STANDARD, &map, visit_and_record,
                                   &recorder.query);
                else
                    spiral_nearest(WRAPAROUND, &map, visit_and_record,
                                   &recorder.query);
                snprintf(what, sizeof what,
                         "geometry %d, %u points, point %u", g, n, i);
                check_walk(&grid, &recorder, what);
            }
            cells_free(&cells);
            grid_free(&grid);
            points_free(&points);
        }
}

// ---- the same answers ----------------------------------------------
static const double densities[] = {0.02, 0.3, 1, 2, 7, 1e6};
enum { DENSITIES = sizeof densities / sizeof *densities };

static void check_density(const struct question *question, double c,
                          const struct answers *right, const char *name)
{
    uint32_t n = question->points.n;
    struct grid grid = grid_fit(question, c);
    struct cells cells = cells_sort(&grid, question->points);
    struct answers found = answers_allocate(n);
    for (int ordered = 0; ordered <= 1; ordered++) {
        memset(found.nearest, 0xA5, n * sizeof *found.nearest);
        memset(found.nearest2, 0xA5, n * sizeof *found.nearest2);
        search_spiral(question, &grid, &cells,
                      ordered ? cells.point : NULL, &found);
        for (uint32_t i = 0; i < n; i++)
            if (!CHECK_DOUBLE(right->nearest2[i], found.nearest2[i],
                              "%u %s points, c %g, geometry %d, %d "
                              "threads: distance of %u",
                              n, name, c, question->space.geometry,
                              question->threads, i) ||
                !CHECK_INT(right->nearest[i], found.nearest[i],
                           "%u %s points, c %g, geometry %d, %d "
                           "threads: nearest of %u",
                           n, name, c, question->space.geometry,
                           question->threads, i))
                break; // one is enough
    }
    answers_free(&found);
    cells_free(&cells);
    grid_free(&grid);
}

static void check_densities(struct points points, struct space space,
                            const char *name)
{
    struct question question = {points, space, 1};
    struct answers right = answers_allocate(points.n);
    search_plainly(&question, &right);
    for (int k = 0; k < DENSITIES; k++) {
        question.threads = 1 + k % 4;
        check_density(&question, densities[k], &right, name);
    }
    answers_free(&right);
}

static void every_generator(void)
{
    static const uint32_t lengths[] = {2, 3, 10, 50, 300};
    for (int d = 0; d < distribution_count; d++)
        for (int k = 0; k < 5; k++) {
            test_seed(k);
            struct points points =
                generate(&distributions[d], lengths[k], k);
            check_densities(points, (struct space){STANDARD, 1, 1},
                            distributions[d].name);
            points_free(&points);
        }
}

// Boxes as wide as they are tall, and not; and points in a corner of
// the box only, so that the way across its border is short for some.
static void around_every_border(void)
{
    for (uint32_t n = 2; n < 400; n = 2 * n + 1)
        for (int shape = 0; shape < 4; shape++) {
            test_seed(n);
            struct points points =
                generate(find_distribution("uniform"), n, n);
            double width = shape == 1 ? 9 : 1;
            double height = shape == 2 ? 9 : 1;
            double part = shape == 3 ? 0.6 : 1;
            for (uint32_t i = 0; i < n; i++) {
                points.x[i] *= part * width;
                points.y[i] *= part * height;
            }
            check_densities(points,
                            (struct space){WRAPAROUND, width, height},
                            "wrapped");
            check_densities(points, (struct space){STANDARD, 1, 1},
                            "stretched");
            points_free(&points);
        }
}

// Multiples of 1/8 lie on borders and tie with each other.
static void ties_across_borders(void)
{
    for (int spacing = 1; spacing <= 3; spacing++) {
        struct points points = points_allocate(64);
        for (uint32_t i = 0; i < 64; i++) {
            uint32_t k = i * 37 % 64;
            points.x[i] = k % 8 * 0.125 * spacing;
            points.y[i] = k / 8 * 0.125 * spacing;
        }
        check_densities(points, (struct space){STANDARD, 1, 1},
                        "tying");
        check_densities(points,
                        (struct space){WRAPAROUND, spacing, spacing},
                        "tying");
        points_free(&points);
    }
}

// A crowd in one corner and somebody far away, who must cross a large
// empty region; squares that overflow, and squares that vanish.
static void empty_regions(void)
{
    struct points points =
        generate(find_distribution("uniform"), 500, 3);
    for (uint32_t i = 0; i < 499; i++) {
        points.x[i] *= 0.01;
        points.y[i] *= 0.01;
    }
    points.x[499] = points.y[499] = 1;
    test_seed(3);
    check_densities(points, (struct space){STANDARD, 1, 1}, "lonely");
    check_densities(points, (struct space){WRAPAROUND, 2, 2}, "lonely");
    points_free(&points);
}

static void extremes(void)
{
    const double scales[] = {1e300, 1e-300, 1e160, 1e-160};
    for (int s = 0; s < 4; s++)
        for (uint32_t n = 2; n <= 200; n = 3 * n + 1) {
            test_seed(n);
            struct points points =
                generate(find_distribution("uniform"), n, n);
            for (uint32_t i = 0; i < n; i++) {
                points.x[i] *= scales[s];
                points.y[i] *= scales[s];
            }
            check_densities(points, (struct space){STANDARD, 1, 1},
                            s % 2 ? "tiny" : "huge");
            points_free(&points);
        }
}

// ---- counts --------------------------------------------------------
// Without a border the expectation holds for all points, and for
// 200,000 of them chance makes a few tenths of a percent.
static void distances_as_expected(void)
{
    struct points points =
        generate(find_distribution("uniform"), 200000, 4);
    struct question question = {points, {WRAPAROUND, 1, 1}, 2};
    test_seed(4);
    for (double c = 0.5; c <= 3; c += 0.5) {
        struct census census = take_census(&question, c);
        struct expected expected = expected_spiral(census.per_cell);
        CHECK_NEAR(expected.distances, census.distances,
                   0.01 * expected.distances,
                   "distances a point, c = %g", c);
        CHECK_NEAR(expected.cells, census.cells, 0.01 * expected.cells,
                   "cells a point, c = %g", c);
    }
    points_free(&points);
}

// A border has fewer cells to look at behind it; a point in a hundred
// lies in the outermost cells.
static void distances_with_a_border(void)
{
    struct points points =
        generate(find_distribution("uniform"), 200000, 5);
    struct question question = {points, {STANDARD, 1, 1}, 2};
    test_seed(5);
    for (double c = 1; c <= 3; c++) {
        struct census census = take_census(&question, c);
        struct expected expected = expected_spiral(census.per_cell);
        CHECK_NEAR(expected.distances, census.distances,
                   0.02 * expected.distances,
                   "distances a point, c = %g", c);
    }
    points_free(&points);
}

// In one cell, everybody meets everybody, and nobody looks elsewhere.
static void all_in_one_cell(void)
{
    struct points points = generate(find_distribution("equal"), 100, 1);
    struct answers answers = answers_allocate(100);
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct counts counts =
        count_operations(find_algorithm("spiral"), &question, &answers);
    CHECK_INT(100 * 99, (long long)counts.distances, "distances");
    CHECK_INT(100, (long long)counts.cells, "cells");
    answers_free(&answers);
    points_free(&points);
}

// Two points in opposite corners of sixteen cells: the first layer that
// is not empty is the last, and phase two has nothing to do.
static void two_points(void)
{
    double x[] = {0, 1}, y[] = {0, 1};
    struct question question = {{2, x, y}, {STANDARD, 1, 1}, 1};
    struct census census = take_census(&question, 0.125);
    CHECK_DOUBLE(1, census.distances, "distances a point");
    CHECK_DOUBLE(16, census.cells, "cells a point");
}

static void census_agrees_with_the_table(void)
{
    struct points points =
        generate(find_distribution("clustered"), 3000, 6);
    struct answers answers = answers_allocate(3000);
    test_seed(6);
    for (uint32_t i = 0; i < 3000; i++)
        points.x[i] += 3, points.y[i] += 3; // into the box
    for (int threads = 1; threads <= 4; threads++)
        for (int g = STANDARD; g <= WRAPAROUND; g++) {
            struct question question = {points, {g, 9, 9}, threads};
            struct counts counts = count_operations(
                find_algorithm("spiral"), &question, &answers);
            struct census census = take_census(&question, 1);
            CHECK_NEAR(counts.distances / 3000.0, census.distances,
                       1e-9, "distances a point, %d threads", threads);
            CHECK_NEAR(counts.cells / 3000.0, census.cells, 1e-9,
                       "cells a point, %d threads", threads);
        }
    answers_free(&answers);
    points_free(&points);
}

int main(void)
{
    return RUN_TESTS(
        "ch07-spiral", TEST(every_cell_once), TEST(views_of_squares),
        TEST(squares_are_closed), TEST(out_in_layers),
        TEST(every_generator), TEST(around_every_border),
        TEST(ties_across_borders), TEST(empty_regions), TEST(extremes),
        TEST(distances_as_expected), TEST(distances_with_a_border),
        TEST(all_in_one_cell), TEST(two_points),
        TEST(census_agrees_with_the_table));
}
