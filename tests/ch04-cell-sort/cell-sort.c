// Cells: exact borders, a sort that keeps order, blocks that know what
// they lack, a search that errs where it must and one that never does;
// and how much was visited.
#include "algorithms.h"
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/block.h"
#include "ch04-cell-sort/experiments/nine_cells.h"
#include "ch04-cell-sort/experiments/poisson.h"
#include "ch04-cell-sort/line.h"
#include "ch04-cell-sort/lists.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/generate.h"
#include "common/random.h"
#include "harness.h"
#include <float.h>
#include <stdlib.h>

// ---- the grid ------------------------------------------------------
static void check_axis(const struct axis *axis, double x,
                       const char *what)
{
    uint32_t k = axis_cell(axis, x);
    if (!CHECK(k < axis->count, "%s: cell %u of %u", what, k,
               axis->count))
        return;
    CHECK(axis->border[k] <= x, "%s: %.17g is not below cell %u, %.17g",
          what, x, k, axis->border[k]);
    CHECK(x < axis->border[k + 1] ||
              (k + 1 == axis->count && x == axis->border[k + 1]),
          "%s: %.17g is not beyond cell %u, %.17g", what, x, k,
          axis->border[k + 1]);
}

// At the borders and on either side of them, and anywhere.
static void check_borders(double low, double high, double period,
                          uint32_t count, const char *what)
{
    struct axis axis = axis_cut(low, high, period, count);
    CHECK(axis.count == count || axis.count == 1, "%s: %u cells", what,
          axis.count);
    CHECK_DOUBLE(low, axis.border[0], "%s: the first border", what);
    CHECK_DOUBLE(high, axis.border[axis.count], "%s: the last", what);
    struct random random = {count};
    for (uint32_t k = 0; k <= axis.count; k++) {
        double x = axis.border[k];
        if (x > high)
            continue; // a cell beyond the points
        check_axis(&axis, x, what);
        if (x > low)
            check_axis(&axis, nextafter(x, low), what);
        if (x < high)
            check_axis(&axis, nextafter(x, high), what);
        double part = random_uniform(&random);
        x = low * (1 - part) + high * part;
        check_axis(&axis, fmax(low, fmin(x, high)), what);
    }
    axis_free(&axis);
}

static void borders_are_exact(void)
{
    static const uint32_t counts[] = {1, 2, 3, 7, 10, 49, 100, 1000};
    for (size_t k = 0; k < sizeof counts / sizeof *counts; k++) {
        uint32_t m = counts[k];
        check_borders(0, 1, INFINITY, m, "unit");
        check_borders(0.1, 0.7, INFINITY, m, "inside");
        check_borders(-1e6 - 0.1, -1e6, INFINITY, m, "far away");
        check_borders(-3, 1e300, INFINITY, m, "long");
        check_borders(1e-300, 1e-299, INFINITY, m, "short");
        check_borders(0, 1e-320, INFINITY, m, "subnormal");
        check_borders(-1e308, 1e308, INFINITY, m, "too long");
        check_borders(1, nextafter(1, 2), INFINITY, m, "one step");
        check_borders(5, 5, INFINITY, m, "no width");
        check_borders(0.3, 0.9, 1, m, "wrapped");
        check_borders(-2, 0.5, 1000, m, "wrapped, mostly empty");
    }
}

static void random_borders(void)
{
    for (uint64_t seed = 0; seed < 3000; seed++) {
        test_seed(seed);
        struct random random = {seed};
        double low = ldexp(random_uniform(&random) - 0.5,
                           (int)(random_bits(&random) % 40) - 20);
        double high =
            low + ldexp(random_uniform(&random),
                        (int)(random_bits(&random) % 40) - 20);
        check_borders(low, high, INFINITY,
                      1 + random_bits(&random) % 50, "random");
    }
}

// A grid has about n / c cells, whatever the shape of the points.
static void cells_never_outnumber_points(void)
{
    static const double per_cell[] = {0.25, 1, 2, 3.7, 100, 1e6};
    for (int d = 0; d < distribution_count; d++)
        for (int k = 0; k < 6; k++)
            for (int outlier = 0; outlier <= 1; outlier++) {
                struct points p = generate(&distributions[d], 1000, 1);
                if (outlier)
                    p.x[7] = 1e9;
                struct question question = {p, {STANDARD, 1, 1}, 1};
                struct grid grid = grid_fit(&question, per_cell[k]);
                CHECK(grid_cells(&grid) <= 1000 / per_cell[k] + 1,
                      "%u cells for 1000 points %s, %g each",
                      grid_cells(&grid), distributions[d].name,
                      per_cell[k]);
                for (uint32_t i = 0; i < p.n; i++) {
                    check_axis(&grid.x, p.x[i], distributions[d].name);
                    check_axis(&grid.y, p.y[i], distributions[d].name);
                }
                grid_free(&grid);
                points_free(&p);
            }
}

// ---- the sort ------------------------------------------------------
static void check_order(struct points points, const uint32_t *order,
                        int threads, const char *what)
{
    struct points sorted = points_in_order(points, order, threads);
    for (uint32_t s = 0; s < points.n; s++) {
        CHECK_DOUBLE(points.x[order[s]], sorted.x[s], "%s: x of %u",
                     what, s);
        CHECK_DOUBLE(points.y[order[s]], sorted.y[s], "%s: y of %u",
                     what, s);
    }
    points_free(&sorted);
}

// Every point is once in the list of its own cell, in ascending order;
// and the lists hold the same, in descending order.
static void check_sort(struct points points, double c, const char *what)
{
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct grid grid = grid_fit(&question, c);
    struct cells cells = cells_sort(&grid, points);
    struct lists lists = lists_make(&grid, points);
    uint32_t m = grid_cells(&grid);
    CHECK_INT(0, cells.start[0], "%s: where the first cell begins",
              what);
    CHECK_INT(points.n, cells.start[m], "%s: where the last ends",
              what);
    for (uint32_t cell = 0; cell < m; cell++) {
        uint32_t j = lists.head[cell];
        for (uint32_t s = cells.start[cell + 1]; s > cells.start[cell];
             s--) {
            uint32_t i = cells.point[s - 1];
            CHECK_INT(cell, grid_cell(&grid, points.x[i], points.y[i]),
                      "%s: cell of point %u", what, i);
            if (s - 1 > cells.start[cell])
                CHECK(cells.point[s - 2] < i, "%s: %u comes after %u",
                      what, i, cells.point[s - 2]);
            if (!CHECK_INT(i, j, "%s: list of cell %u", what, cell))
                break;
            j = lists.next[j];
        }
        CHECK_INT(NO_INDEX, j, "%s: the end of list %u", what, cell);
    }
    for (int threads = 1; threads <= 4; threads *= 2)
        check_order(points, cells.point, threads, what);
    lists_free(&lists);
    cells_free(&cells);
    grid_free(&grid);
}

static void sorts_every_distribution(void)
{
    static const uint32_t sizes[] = {2, 3, 10, 257, 1000};
    static const double per_cell[] = {0.3, 1, 2, 50, 1e5};
    for (int d = 0; d < distribution_count; d++)
        for (int s = 0; s < 5; s++)
            for (int k = 0; k < 5; k++) {
                struct points points =
                    generate(&distributions[d], sizes[s], 1);
                check_sort(points, per_cell[k], distributions[d].name);
                points_free(&points);
            }
}

// ---- the line ------------------------------------------------------
// Three ways to find the numbers between a and b find the same, also
// where a or b is a number, a border, or beyond all of them.
static void check_between(const double *x, const double *sorted,
                          const struct bins *bins, uint32_t n, double a,
                          double b)
{
    static double by_scan[100], by_halves[100], by_bins[100];
    uint32_t count = scan_between(x, n, a, b, by_scan);
    uint32_t plainly = 0;
    for (uint32_t i = 0; i < n; i++)
        if (a <= x[i] && x[i] < b)
            CHECK_DOUBLE(x[i], by_scan[plainly++], "scan, [%g, %g)", a,
                         b);
    CHECK_INT(plainly, count, "how many by scan, [%g, %g)", a, b);
    CHECK_INT(plainly, sorted_between(sorted, n, a, b, by_halves),
              "how many by halves, [%g, %g)", a, b);
    CHECK_INT(plainly, bins_between(bins, a, b, by_bins),
              "how many in bins, [%g, %g)", a, b);
    sort_numbers(by_scan, plainly);
    sort_numbers(by_bins, plainly);
    for (uint32_t k = 0; k < plainly; k++) {
        CHECK_DOUBLE(by_scan[k], by_halves[k], "by halves, number %u",
                     k);
        CHECK_DOUBLE(by_scan[k], by_bins[k], "in bins, number %u", k);
    }
}

static void numbers_on_a_line(void)
{
    for (uint64_t seed = 0; seed < 300; seed++) {
        test_seed(seed);
        struct random random = {seed};
        double x[100], sorted[100];
        uint32_t n = 1 + random_bits(&random) % 100;
        for (uint32_t i = 0; i < n; i++)
            x[i] = sorted[i] = seed % 2
                                   ? random_uniform(&random)
                                   : random_bits(&random) % 7 * 0.1;
        sort_numbers(sorted, n);
        struct bins bins = bins_make(x, n, 0.5 + seed % 4);
        for (int k = 0; k < 20; k++) {
            double a = 2 * random_uniform(&random) - 0.5;
            double b = 2 * random_uniform(&random) - 0.5;
            check_between(x, sorted, &bins, n, a, b);
            check_between(x, sorted, &bins, n, x[k % n], b);
            check_between(x, sorted, &bins, n, a, x[k % n]);
        }
        check_between(x, sorted, &bins, n, -INFINITY, INFINITY);
        bins_free(&bins);
    }
}

// ---- the block -----------------------------------------------------
static bool in_reach(const struct axis *axis,
                     const struct axis_range *reach, uint32_t cell)
{
    int times = 0;
    for (uint32_t k = 0; k < reach->count; k++)
        times += range_cell(axis, reach, k) == cell;
    CHECK(times <= 1, "cell %u is visited %d times", cell, times);
    return times;
}

// Whatever lies outside of a block is not nearer than its margin; in
// both geometries, with blocks that wrap round.
static void margins_hold(void)
{
    for (uint64_t seed = 0; seed < 60; seed++) {
        test_seed(seed);
        enum geometry geometry = seed % 2 ? STANDARD : WRAPAROUND;
        struct points p =
            generate(find_distribution("uniform"), 30 + seed, seed);
        struct question question = {p, {geometry, 1, 1}, 1};
        struct grid grid = grid_fit(&question, 1 + seed % 3);
        for (uint32_t i = 0; i < p.n; i++)
            for (uint32_t radius = 1; radius <= 16; radius *= 2) {
                struct block block =
                    block_of(&grid, p.x[i], p.y[i], radius);
                double margin =
                    block_margin(&grid, &block, p.x[i], p.y[i]);
                bool all = block.x.count == grid.x.count &&
                           block.y.count == grid.y.count;
                CHECK_INT(all, margin == INFINITY,
                          "radius %u: the block has all", radius);
                CHECK_INT(all, block_covers(&grid, &block),
                          "radius %u: and knows it", radius);
                for (uint32_t j = 0; j < p.n; j++) {
                    uint32_t x = axis_cell(&grid.x, p.x[j]);
                    uint32_t y = axis_cell(&grid.y, p.y[j]);
                    bool inside = in_reach(&grid.x, &block.x, x) &&
                                  in_reach(&grid.y, &block.y, y);
                    double d2 =
                        closest2(question.space, p.x[j] - p.x[i],
                                 p.y[j] - p.y[i]);
                    CHECK(inside || d2 >= margin * margin,
                          "point %u is outside the block of %u, at "
                          "%.17g, but the margin is %.17g",
                          j, i, sqrt(d2), margin);
                }
            }
        grid_free(&grid);
        points_free(&p);
    }
}

// ---- the search ----------------------------------------------------
static uint32_t wrong(const struct answers *right,
                      const struct answers *found, uint32_t n)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < n; i++)
        count += right->nearest[i] != found->nearest[i] ||
                 right->nearest2[i] != found->nearest2[i];
    return count;
}

// Four by four cells, of side 1. Point 0 is near the right border of
// its block, point 1 just beyond: nearer than point 2, in the block.
static void nine_cells_are_not_enough(void)
{
    double x[16] = {1.9, 3.1, 0.4, 0, 4, 0, 4, 0,
                    4,   0,   4,   0, 4, 0, 4, 4};
    double y[16] = {1.5, 1.5, 1.5, 0, 4, 4, 0, 0,
                    4,   4,   0,   0, 4, 4, 0, 0};
    struct question question = {{16, x, y}, {STANDARD, 0, 0}, 1};
    struct answers answers = answers_allocate(16);
    struct sorted s = sorted_make(&question, 1);
    CHECK_INT(16, grid_cells(&s.grid), "cells");
    search_nine_cells(&question, &s, &answers);
    CHECK_INT(2, answers.nearest[0], "without the test, the wrong one");
    search_sorted(&question, &s, &answers);
    CHECK_INT(1, answers.nearest[0], "with it, the right one");
    sorted_free(&s);
    answers_free(&answers);
}

// Without the test about three in a thousand are wrong at c = 1; with
// it, none. The right answers come from the naive search.
static void the_test_makes_it_right(void)
{
    static const double per_cell[] = {0.25, 0.5, 1};
    for (int g = STANDARD; g <= WRAPAROUND; g++) {
        struct question question = {
            generate(find_distribution("uniform"), 3000, 4),
            {g, 1, 1},
            1};
        struct answers right = answers_allocate(3000);
        struct answers found = answers_allocate(3000);
        search_plainly(&question, &right);
        for (int k = 0; k < 3; k++) {
            struct sorted s = sorted_make(&question, per_cell[k]);
            search_nine_cells(&question, &s, &found);
            CHECK(wrong(&right, &found, 3000) > 0,
                  "wrong without the test, c = %g", per_cell[k]);
            search_sorted(&question, &s, &found);
            CHECK_INT(0, wrong(&right, &found, 3000),
                      "wrong with the test, c = %g", per_cell[k]);
            sorted_free(&s);
        }
        answers_free(&right);
        answers_free(&found);
        points_free(&question.points);
    }
}

// Of the box of the points.
static double longest_side(struct points p)
{
    double x0 = p.x[0], x1 = x0, y0 = p.y[0], y1 = y0;
    for (uint32_t i = 1; i < p.n; i++) {
        x0 = fmin(x0, p.x[i]), x1 = fmax(x1, p.x[i]);
        y0 = fmin(y0, p.y[i]), y1 = fmax(y1, p.y[i]);
    }
    return fmax(x1 - x0, y1 - y0);
}

// Any c, any order of queries, any number of threads.
static void every_search_agrees(void)
{
    static const double per_cell[] = {0.1, 0.7, 2, 9, 1e9};
    for (int d = 0; d < distribution_count; d++)
        for (int g = STANDARD; g <= WRAPAROUND; g++) {
            struct points points =
                generate(&distributions[d],
                         at_most("MOST_POINTS", 7000) / 10, 2);
            const double side = 4 + longest_side(points);
            struct question question = {points, {g, side, side}, 1};
            uint32_t n = question.points.n;
            struct answers right = answers_allocate(n);
            struct answers found = answers_allocate(n);
            search_plainly(&question, &right);
            for (int k = 0; k < 5; k++) {
                question.threads = 1 + k % 3;
                struct sorted s = sorted_make(&question, per_cell[k]);
                struct lists lists =
                    lists_make(&s.grid, question.points);
                for (int way = 0; way < 6; way++) {
                    const uint32_t *order =
                        way % 2 ? s.cells.point : NULL;
                    if (way < 2)
                        search_lists(&question, &s.grid, &lists, order,
                                     &found);
                    else if (way < 4)
                        search_indices(&question, &s.grid, &s.cells,
                                       order, &found);
                    else if (way == 4)
                        search_sorted(&question, &s, &found);
                    else
                        search_batches(&question, &s, &found);
                    CHECK_INT(0, wrong(&right, &found, n),
                              "wrong: %s, c = %g, way %d, geometry %d",
                              distributions[d].name, per_cell[k], way,
                              g);
                }
                lists_free(&lists);
                sorted_free(&s);
            }
            answers_free(&right);
            answers_free(&found);
            points_free(&question.points);
        }
}

// ---- how much it looks at ------------------------------------------
static struct counts count(const struct question *question, double c,
                           struct answers *answers)
{
    struct sorted s = sorted_make(question, c);
    struct counts counts = {0};
    struct question counted = *question;
    counted.counts = &counts;
    search_sorted(&counted, &s, answers);
    sorted_free(&s);
    return counts;
}

// Three percent: with wraparound there is no border. In a bounded
// square a block at the border has only six cells, or four.
static void counts_are_as_predicted(void)
{
    const uint32_t n = 40000;
    struct answers answers = answers_allocate(n);
    for (uint64_t seed = 1; seed <= 3; seed++)
        for (double c = 1; c <= 3; c++) {
            test_seed(seed);
            struct question question = {
                generate(find_distribution("uniform"), n, seed),
                {WRAPAROUND, 1, 1},
                2};
            struct counts found = count(&question, c, &answers);
            double cells = expected_cells(c);
            double distances = expected_distances(c);
            CHECK_NEAR(cells, (double)found.cells / n, 0.03 * cells,
                       "cells a point, c = %g", c);
            CHECK_NEAR(distances, (double)found.distances / n,
                       0.03 * distances, "distances a point, c = %g",
                       c);
            question.space.geometry = STANDARD;
            double inside = 1 - 2 / (3 * sqrt(n / c));
            found = count(&question, c, &answers);
            CHECK_NEAR(cells * inside * inside, (double)found.cells / n,
                       0.03 * cells, "bounded: cells a point, c = %g",
                       c);
            CHECK_NEAR(distances * inside * inside,
                       (double)found.distances / n, 0.03 * distances,
                       "bounded: distances a point, c = %g", c);
            points_free(&question.points);
        }
    answers_free(&answers);
}

// Four queries of a batch have a block of three rows and, on average, 3
// and 3 / c columns, and meet themselves and, on average, one more at
// either end of their cells.
static void counts_of_four(void)
{
    const uint32_t n = 40000, c = POINTS_PER_CELL;
    struct answers answers = answers_allocate(n);
    struct question question = {
        generate(find_distribution("uniform"), n, 1),
        {WRAPAROUND, 1, 1},
        1};
    double expected = 9 * c + 9 + 1;
    struct counts found =
        count_operations(find_algorithm("cells"), &question, &answers);
    CHECK_NEAR(expected, (double)found.distances / n, 0.04 * expected,
               "distances a point, batches of four");
    points_free(&question.points);
    answers_free(&answers);
}

// The share of wrong answers, against the one derived; some hundreds of
// them, so that chance moves it by a few percent.
static void errors_are_as_predicted(void)
{
    const uint32_t n = 40000;
    struct answers right = answers_allocate(n);
    struct answers found = answers_allocate(n);
    for (double c = 0.25; c <= 1; c *= 2) {
        uint32_t errors = 0, sets = c < 1 ? 2 : 8;
        for (uint32_t seed = 1; seed <= sets; seed++) {
            struct question question = {
                generate(find_distribution("uniform"), n, seed),
                {WRAPAROUND, 1, 1},
                2};
            struct sorted s = sorted_make(&question, c);
            search_sorted(&question, &s, &right);
            search_nine_cells(&question, &s, &found);
            errors += wrong(&right, &found, n);
            sorted_free(&s);
            points_free(&question.points);
        }
        double expected = expected_wrong(c);
        CHECK_NEAR(expected, (double)errors / n / sets, 0.15 * expected,
                   "share of wrong neighbors, c = %g", c);
    }
    answers_free(&right);
    answers_free(&found);
}

// One point far from all others, which share a few cells.
static void a_far_point(void)
{
    const uint32_t n = at_most("MOST_POINTS", 5000);
    struct points points = generate(find_distribution("uniform"), n, 1);
    points.x[0] = points.y[0] = 100;
    struct question question = {points, {STANDARD, 0, 0}, 1};
    struct answers answers = answers_allocate(n);
    struct answers right = answers_allocate(n);
    search_plainly(&question, &right);
    for (int row = 0; row < algorithm_count; row++) {
        const struct algorithm *a = &algorithms[row];
        if (a->chapter != 4)
            continue;
        int64_t built = 0;
        question.built_ns = &built;
        a->run(&question, &answers);
        CHECK_INT(0, wrong(&right, &answers, n), "wrong, %s", a->name);
        CHECK(built > 0, "%s says when it stood", a->name);
    }
    points_free(&points);
    answers_free(&right);
    answers_free(&answers);
}

// In a grid of four by four cells, the block of point 1 ends where
// point 0 stands, which is as near as point 2, in the block: a tie that
// only the next block shows. Points 3 and 4, of the same batch, have
// each other.
static void a_tie_on_the_border(void)
{
    double x[] = {1.5, 1.5, 0, 4, 4, 4};
    double y[] = {2, 0.5, 0.5, 0, 0.125, 4};
    struct question question = {{6, x, y}, {STANDARD, 0, 0}, 1};
    struct answers answers = answers_allocate(6);
    struct sorted sorted = sorted_make(&question, 6 / 16.0);
    CHECK_INT(16, (long long)grid_cells(&sorted.grid), "cells");
    search_sorted(&question, &sorted, &answers);
    CHECK_INT(0, answers.nearest[1], "point by point");
    search_batches(&question, &sorted, &answers);
    CHECK_INT(0, answers.nearest[1], "in batches");
    sorted_free(&sorted);
    answers_free(&answers);
}

// A box of one rounding step round points of the same height, with
// cells beyond them: a border there is farther away than the box is
// high, and must not pass for a way around it.
static void cells_beyond_the_points(void)
{
    const uint32_t cases = at_most("MOST_CASES", 20000) / 10;
    for (uint64_t seed = 0; seed < cases; seed++) {
        test_seed(seed);
        struct random random = {seed};
        struct points p = points_allocate(40);
        double width = 0x1p-53 * (1 + random_bits(&random) % 4);
        for (uint32_t i = 0; i < p.n; i++) {
            double part = random_uniform(&random);
            p.x[i] = width * part * part * part * part;
            p.y[i] = 1;
        }
        struct question question = {p, {WRAPAROUND, width, 0x1p-53}, 1};
        struct answers right = answers_allocate(p.n);
        struct answers found = answers_allocate(p.n);
        search_plainly(&question, &right);
        for (int row = 0; row < algorithm_count; row++) {
            algorithms[row].run(&question, &found);
            for (uint32_t i = 0; i < p.n; i++)
                if (!CHECK_INT(right.nearest[i], found.nearest[i],
                               "%s: neighbor of point %u",
                               algorithms[row].name, i))
                    break;
        }
        answers_free(&found);
        answers_free(&right);
        points_free(&p);
    }
}

int main(void)
{
    return RUN_TESTS(
        "ch04-cell-sort", TEST(borders_are_exact), TEST(random_borders),
        TEST(cells_never_outnumber_points),
        TEST(sorts_every_distribution), TEST(numbers_on_a_line),
        TEST(margins_hold), TEST(nine_cells_are_not_enough),
        TEST(the_test_makes_it_right), TEST(every_search_agrees),
        TEST(counts_are_as_predicted), TEST(counts_of_four),
        TEST(errors_are_as_predicted), TEST(a_far_point),
        TEST(a_tie_on_the_border), TEST(cells_beyond_the_points));
}
