// The checks of chapter 9's kernels, for one instruction set: against
// the plainest search there is, by batches, by pruned queries and by
// queries of whole blocks, for any number of points to a cell. For
// tests/instructions, too.
#pragma once
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/span_kernels.h"

#include "common/allocate.h"
#include "common/generate.h"
#include "common/random.h"
#include "harness.h"
#include <stdlib.h>
#include <string.h>

static const double span_densities[] = {0.02, 0.3, 1, 1.5, 4, 20, 1e6};
enum {
    SPAN_DENSITIES = sizeof span_densities / sizeof *span_densities,
    MODES = 3
};
enum span_mode { BATCHED, PRUNED, WHOLE };

struct checked_spans {
    const struct span_kernels *kernels;
    const char *points;
};

// Every row of the block, in blocks that are doubled.
static inline struct query query_whole_block(const struct scene *scene,
                                             uint32_t s)
{
    const struct grid *grid = &scene->sorted->grid;
    struct query query = query_of(scene->sorted, s);
    for (uint32_t radius = 1;; radius *= 2) {
        struct block block = block_of(grid, query.x, query.y, radius);
        for (uint32_t k = 0; k < block.y.count; k++)
            compare_row(scene, &block.x,
                        range_cell(&grid->y, &block.y, k), &query);
        double margin = block_margin(grid, &block, query.x, query.y);
        if (query.best2 < margin * margin || block_covers(grid, &block))
            return query;
    }
}

// From begin on in pieces of different lengths, so that batches begin
// anywhere and end anywhere.
static inline void search_in_pieces(const struct scene *scene,
                                    enum span_mode mode, uint32_t piece,
                                    struct answers *found)
{
    const struct sorted *sorted = scene->sorted;
    const uint32_t n = sorted->points.n;
    const uint32_t *point = sorted->cells.point;
    struct neighbor *results = allocate(n, sizeof *results);
    uint32_t *order = allocate(n, sizeof *order);
    struct counts counts = {0};
    for (uint32_t s = 0; s < n; s++)
        order[s] = n - 1 - s;
    memset(results, 0xA5, n * sizeof *results);
    for (uint64_t begin = 0; begin < n && mode == BATCHED;
         begin += piece) {
        uint64_t end = begin + piece < n ? begin + piece : n;
        struct batch_search search =
            nearest_search(scene, order, results);
        answer_chunk(scene, &search, 1, begin, end, &counts);
    }
    for (uint32_t s = 0; s < n && mode != BATCHED; s++) {
        struct query query = mode == PRUNED
                                 ? nearest_query(scene, s)
                                 : query_whole_block(scene, s);
        results[order[s]] =
            (struct neighbor){query.best2, query.nearest};
    }
    for (uint32_t s = 0; s < n; s++) {
        found->nearest[point[s]] = results[order[s]].index;
        found->nearest2[point[s]] = results[order[s]].distance2;
    }
    free(order);
    free(results);
}

static inline void check_span_answers(
    const struct checked_spans *checked,
    const struct question *question, double c, enum span_mode mode,
    const struct answers *right, const struct answers *found)
{
    for (uint32_t i = 0; i < question->points.n; i++)
        if (!CHECK_DOUBLE(right->nearest2[i], found->nearest2[i],
                          "%s, %u %s points, c %g, geometry %d, mode "
                          "%d: distance of %u",
                          checked->kernels->name, question->points.n,
                          checked->points, c, question->space.geometry,
                          mode, i) ||
            !CHECK_INT(right->nearest[i], found->nearest[i],
                       "%s, %u %s points, c %g, geometry %d, mode "
                       "%d: nearest of %u",
                       checked->kernels->name, question->points.n,
                       checked->points, c, question->space.geometry,
                       mode, i))
            return; // one is enough
}

static inline void check_spans_of(const struct span_kernels *kernels,
                                  struct points points,
                                  struct space space, const char *name)
{
    const struct checked_spans checked = {kernels, name};
    struct question question = {points, space, 1};
    struct answers right = answers_allocate(points.n);
    struct answers found = answers_allocate(points.n);
    search_plainly(&question, &right);
    for (int k = 0; k < SPAN_DENSITIES; k++) {
        struct sorted sorted =
            sorted_make(&question, span_densities[k]);
        const struct scene scene = {space, &sorted, kernels};
        // Where cells are few, pruned queries see whole blocks, too.
        const int modes = span_densities[k] > 4 ? WHOLE : MODES;
        for (int mode = 0; mode < modes; mode++) {
            search_in_pieces(&scene, mode, k % 2 ? UINT32_MAX : 13,
                             &found);
            check_span_answers(&checked, &question, span_densities[k],
                               mode, &right, &found);
        }
        sorted_free(&sorted);
    }
    answers_free(&found);
    answers_free(&right);
}

static inline void check_span_generators(
    const struct span_kernels *kernels)
{
    static const uint32_t lengths[] = {2, 3, 8, 9, 50, 300, 1200};
    const uint32_t longest = at_most("MOST_POINTS", 12000) / 10;
    for (int d = 0; d < distribution_count; d++)
        for (int k = 0; k < 7 && lengths[k] <= longest; k++) {
            test_seed(k);
            struct points points =
                generate(&distributions[d], lengths[k], k);
            check_spans_of(kernels, points,
                           (struct space){STANDARD, 1, 1},
                           distributions[d].name);
            points_free(&points);
        }
}

// Boxes as wide as they are tall, and not; and points in a corner of
// the box only, so that the way across its border is short for some.
static inline void check_span_borders(
    const struct span_kernels *kernels)
{
    for (uint32_t n = 2; n < 800; n = 2 * n + 1)
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
            check_spans_of(kernels, points,
                           (struct space){WRAPAROUND, width, height},
                           "wrapped");
            check_spans_of(kernels, points,
                           (struct space){STANDARD, 1, 1}, "stretched");
            points_free(&points);
        }
}

// Neighbors that single precision cannot tell apart: on a lattice that
// is shaken by 1e-2 down to 1e-17 of its step, and far from the origin.
static inline void check_span_shaken(const struct span_kernels *kernels)
{
    for (double shake = 1e-2; shake > 1e-18; shake /= 10)
        for (int far = 0; far <= 1; far++) {
            test_seed(1);
            struct random random = {1};
            struct points points = points_allocate(400);
            for (uint32_t i = 0; i < 400; i++) {
                uint32_t k = i * 37 % 400;
                points.x[i] = k % 20 + shake * random_uniform(&random) +
                              1e6 * far;
                points.y[i] = k / 20 + shake * random_uniform(&random) -
                              1e6 * far;
            }
            check_spans_of(kernels, points,
                           (struct space){STANDARD, 1, 1}, "shaken");
            if (!far)
                check_spans_of(kernels, points,
                               (struct space){WRAPAROUND, 20.5, 21},
                               "shaken");
            points_free(&points);
        }
}

// A box that ends at a power of two: one period further on, doubles are
// twice as coarse.
static inline void check_span_seams(const struct span_kernels *kernels)
{
    const double width = 16;
    for (int exponent = 40; exponent <= 50; exponent++)
        for (uint32_t seed = 1; seed <= 4; seed++) {
            test_seed(seed);
            struct points points =
                generate(find_distribution("uniform"), 400, seed);
            double low = ldexp(1, exponent) - width;
            for (uint32_t i = 0; i < points.n; i++) {
                points.x[i] = low + width * points.x[i];
                points.y[i] = low + width * points.y[i];
            }
            check_spans_of(kernels, points,
                           (struct space){WRAPAROUND, width, width},
                           "far from the origin");
            points_free(&points);
        }
}

// Coordinates that floats cannot hold, or whose squares they cannot.
static inline void check_span_scales(const struct span_kernels *kernels)
{
    for (int exponent = -320; exponent <= 300; exponent += 31)
        for (uint32_t n = 20; n <= 200; n *= 10) {
            test_seed(n);
            struct points points =
                generate(find_distribution("uniform"), n, n);
            for (uint32_t i = 0; i < n; i++) {
                points.x[i] *= pow(10, exponent);
                points.y[i] *= pow(10, exponent);
            }
            check_spans_of(kernels, points,
                           (struct space){STANDARD, 1, 1}, "scaled");
            points_free(&points);
        }
}

// More candidates than can be staged for forty queries, or for eight;
// and a crowd among few.
static inline void check_span_crowds(const struct span_kernels *kernels)
{
    for (uint32_t crowd = 50; crowd <= 74; crowd += 2) {
        test_seed(crowd);
        struct points points =
            generate(find_distribution("uniform"), crowd + 60, crowd);
        for (uint32_t i = 0; i < crowd; i++) {
            points.x[i] = 0.5 + 0.004 * points.x[i];
            points.y[i] = 0.5 + 0.004 * points.y[i];
        }
        check_spans_of(kernels, points, (struct space){STANDARD, 1, 1},
                       "crowded");
        check_spans_of(kernels, points,
                       (struct space){WRAPAROUND, 1, 1}, "crowded");
        points_free(&points);
    }
}

// With 0.3 points in a cell the grid has 4 by 4. The last but two is as
// far from the second as from the first, which stands on the edge of
// its block, outside.
static inline void check_span_edges(const struct span_kernels *kernels)
{
    double x[] = {1.25, 2.75, 1.25, 0, 4};
    double y[] = {3, 1.5, 1.5, 0, 4};
    check_spans_of(kernels, (struct points){5, x, y},
                   (struct space){STANDARD, 1, 1}, "tied");
}

static inline void check_spans(const struct span_kernels *kernels)
{
    check_span_generators(kernels);
    check_span_borders(kernels);
    check_span_shaken(kernels);
    check_span_seams(kernels);
    check_span_scales(kernels);
    check_span_crowds(kernels);
    check_span_edges(kernels);
}
