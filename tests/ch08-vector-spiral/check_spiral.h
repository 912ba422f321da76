// A version of the two inner loops against the plainest search there
// is: the same answers to the last bit and the lowest index, for strips
// of any length, any number of threads and in both geometries.
#pragma once
#include "ch08-vector-spiral/lockstep.h"
#include "common/generate.h"
#include "harness.h"
#include <stdio.h>
#include <string.h>

static void check_strip(const struct question *question, double c,
                        const struct spiral_kernels *kernels,
                        uint32_t length, const struct answers *right,
                        const char *what)
{
    uint32_t n = question->points.n;
    struct grid grid = grid_fit(question, c);
    struct cells cells = cells_sort(&grid, question->points);
    struct answers found = answers_allocate(n);
    memset(found.nearest, 0xA5, n * sizeof *found.nearest);
    memset(found.nearest2, 0xA5, n * sizeof *found.nearest2);
    struct strip_plan plan = {.kernels = kernels, .length = length};
    search_in_lockstep(question, &grid, &cells, &plan, &found);
    for (uint32_t i = 0; i < n; i++)
        if (!CHECK_DOUBLE(right->nearest2[i], found.nearest2[i],
                          "%s, %u points, c %g, geometry %d, strips of "
                          "%u, %d threads: distance of %u",
                          what, n, c, question->space.geometry, length,
                          question->threads, i) ||
            !CHECK_INT(right->nearest[i], found.nearest[i],
                       "%s, %u points, c %g, geometry %d, strips of "
                       "%u, %d threads: nearest of %u",
                       what, n, c, question->space.geometry, length,
                       question->threads, i))
            break; // one is enough
    answers_free(&found);
    cells_free(&cells);
    grid_free(&grid);
}

static void check_points(struct points points, struct space space,
                         const struct spiral_kernels *kernels,
                         const char *what)
{
    static const uint32_t lengths[] = {1, 7, 64, 4096};
    static const double densities[] = {0.1, 1, 5};
    struct question question = {points, space, 1};
    struct answers right = answers_allocate(points.n);
    search_plainly(&question, &right);
    // Another number of threads means new threads: not at each strip.
    for (uint32_t t = 0; t < 3; t++)
        for (uint32_t k = 0; k < 4; k++)
            for (uint32_t d = 0; d < 3; d++) {
                question.threads = 1 << t;
                if ((k + d + points.n) % 3 == t)
                    check_strip(&question, densities[d], kernels,
                                lengths[k], &right, what);
            }
    answers_free(&right);
}

// Coordinates as they are, so that they lie on borders and tie, and
// with wraparound in a box that just holds them.
static void check_both(struct points points,
                       const struct spiral_kernels *kernels,
                       const char *what)
{
    double width = 1, height = 1;
    for (uint32_t i = 0; i < points.n; i++) {
        width = fmax(width, fabs(points.x[i]) * 2);
        height = fmax(height, fabs(points.y[i]) * 2);
    }
    check_points(points, (struct space){STANDARD, 1, 1}, kernels, what);
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] += width > 1 ? width / 2 : 0;
        points.y[i] += height > 1 ? height / 2 : 0;
    }
    check_points(points, (struct space){WRAPAROUND, width, height},
                 kernels, what);
}

// More points than the longest strip takes.
static void check_long_strips(const struct spiral_kernels *kernels,
                              const char *what)
{
    test_seed(5);
    struct points points =
        generate(find_distribution("uniform"), 4500, 5);
    struct question question = {points, {WRAPAROUND, 1, 1}, 2};
    struct answers right = answers_allocate(points.n);
    search_plainly(&question, &right);
    check_strip(&question, 1, kernels, 4096, &right, what);
    answers_free(&right);
    points_free(&points);
}

static void check_spiral(const struct spiral_kernels *kernels,
                         const char *name)
{
    static const uint32_t lengths[] = {2, 9, 50, 300};
    char what[100];
    for (int d = 0; d < distribution_count; d++)
        for (int k = 0; k < 4; k++) {
            test_seed(k);
            struct points points =
                generate(&distributions[d], lengths[k], k);
            snprintf(what, sizeof what, "%s, %s", name,
                     distributions[d].name);
            check_both(points, kernels, what);
            points_free(&points);
        }
    check_long_strips(kernels, name);
}
