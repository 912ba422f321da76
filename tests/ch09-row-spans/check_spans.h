// The checks of chapter 9's search, for one instruction set: against
// the plainest search there is, in every manner of asking, for any
// number of points to a cell. For tests/instructions, too.
#pragma once
#include "ch09-row-spans/manners.h"

#include "common/generate.h"
#include "common/random.h"
#include "harness.h"
#include <string.h>

static const double span_densities[] = {0.02, 0.3, 1, 1.5, 4, 20, 1e6};
enum {
    SPAN_DENSITIES = sizeof span_densities / sizeof *span_densities,
    MANNERS = 3
};

struct checked_spans {
    span_search *search;
    const char *isa, *points;
};

// From begin on in pieces of different lengths, so that tiles begin
// anywhere and end anywhere.
static inline void search_in_pieces(const struct checked_spans *checked,
                                    const struct question *question,
                                    const struct sorted *sorted,
                                    enum manner manner, uint32_t piece,
                                    struct answers *found)
{
    const uint32_t n = sorted->points.n;
    const uint32_t *point = sorted->cells.point;
    struct answers ordered = answers_allocate(n);
    memset(ordered.nearest, 0xA5, n * sizeof *ordered.nearest);
    memset(ordered.nearest2, 0xA5, n * sizeof *ordered.nearest2);
    for (uint64_t begin = 0; begin < n; begin += piece) {
        uint64_t end = begin + piece < n ? begin + piece : n;
        struct answers part = {.nearest = ordered.nearest + begin,
                               .nearest2 = ordered.nearest2 + begin};
        checked->search(question, sorted, manner, NULL, begin, end,
                        &part);
    }
    for (uint32_t s = 0; s < n; s++) {
        found->nearest[point[s]] = ordered.nearest[s];
        found->nearest2[point[s]] = ordered.nearest2[s];
    }
    answers_free(&ordered);
}

static inline void check_span_answers(
    const struct checked_spans *checked,
    const struct question *question, double c, enum manner manner,
    const struct answers *right, const struct answers *found)
{
    for (uint32_t i = 0; i < question->points.n; i++)
        if (!CHECK_DOUBLE(right->nearest2[i], found->nearest2[i],
                          "%s, %u %s points, c %g, geometry %d, manner "
                          "%d: distance of %u",
                          checked->isa, question->points.n,
                          checked->points, c, question->space.geometry,
                          manner, i) ||
            !CHECK_INT(right->nearest[i], found->nearest[i],
                       "%s, %u %s points, c %g, geometry %d, manner "
                       "%d: nearest of %u",
                       checked->isa, question->points.n,
                       checked->points, c, question->space.geometry,
                       manner, i))
            return; // one is enough
}

static inline void check_spans_of(span_search *search, const char *isa,
                                  struct points points,
                                  struct space space, const char *name)
{
    const struct checked_spans checked = {search, isa, name};
    struct question question = {points, space, 1};
    struct answers right = answers_allocate(points.n);
    struct answers found = answers_allocate(points.n);
    search_plainly(&question, &right);
    for (int k = 0; k < SPAN_DENSITIES; k++) {
        struct sorted sorted =
            sorted_make(&question, span_densities[k], cells_sort_alone);
        for (int manner = 0; manner < MANNERS; manner++) {
            search_in_pieces(&checked, &question, &sorted, manner,
                             k % 2 ? UINT32_MAX : 13, &found);
            check_span_answers(&checked, &question, span_densities[k],
                               manner, &right, &found);
        }
        sorted_free(&sorted);
    }
    answers_free(&found);
    answers_free(&right);
}

static inline void check_span_generators(span_search *search,
                                         const char *isa)
{
    static const uint32_t lengths[] = {2, 3, 8, 9, 50, 300, 1200};
    for (int d = 0; d < distribution_count; d++)
        for (int k = 0; k < 7; k++) {
            test_seed(k);
            struct points points =
                generate(&distributions[d], lengths[k], k);
            check_spans_of(search, isa, points,
                           (struct space){STANDARD, 1, 1},
                           distributions[d].name);
            points_free(&points);
        }
}

// Boxes as wide as they are tall, and not; and points in a corner of
// the box only, so that the way across its border is short for some.
static inline void check_span_borders(span_search *search,
                                      const char *isa)
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
            check_spans_of(search, isa, points,
                           (struct space){WRAPAROUND, width, height},
                           "wrapped");
            check_spans_of(search, isa, points,
                           (struct space){STANDARD, 1, 1}, "stretched");
            points_free(&points);
        }
}

// Neighbors that single precision cannot tell apart: on a lattice that
// is shaken by 1e-2 down to 1e-17 of its step, and far from the origin.
static inline void check_span_shaken(span_search *search,
                                     const char *isa)
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
            check_spans_of(search, isa, points,
                           (struct space){STANDARD, 1, 1}, "shaken");
            if (!far)
                check_spans_of(search, isa, points,
                               (struct space){WRAPAROUND, 20.5, 21},
                               "shaken");
            points_free(&points);
        }
}

// A box that ends at a power of two: one period further on, doubles are
// twice as coarse.
static inline void check_span_seams(span_search *search,
                                    const char *isa)
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
            check_spans_of(search, isa, points,
                           (struct space){WRAPAROUND, width, width},
                           "far from the origin");
            points_free(&points);
        }
}

// Coordinates that floats cannot hold, or whose squares they cannot.
static inline void check_span_scales(span_search *search,
                                     const char *isa)
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
            check_spans_of(search, isa, points,
                           (struct space){STANDARD, 1, 1}, "scaled");
            points_free(&points);
        }
}

// As many candidates as the table takes, one less and one more; and a
// crowd among few.
static inline void check_span_crowds(span_search *search,
                                     const char *isa)
{
    for (uint32_t crowd = 228; crowd <= 260; crowd += 4) {
        test_seed(crowd);
        struct points points =
            generate(find_distribution("uniform"), crowd + 60, crowd);
        for (uint32_t i = 0; i < crowd; i++) {
            points.x[i] = 0.5 + 0.004 * points.x[i];
            points.y[i] = 0.5 + 0.004 * points.y[i];
        }
        check_spans_of(search, isa, points,
                       (struct space){STANDARD, 1, 1}, "crowded");
        check_spans_of(search, isa, points,
                       (struct space){WRAPAROUND, 1, 1}, "crowded");
        points_free(&points);
    }
}

// With 0.3 points in a cell the grid has 4 by 4. The last but two is as
// far from the second as from the first, which stands on the edge of
// its block, outside.
static inline void check_span_edges(span_search *search,
                                    const char *isa)
{
    double x[] = {1.25, 2.75, 1.25, 0, 4};
    double y[] = {3, 1.5, 1.5, 0, 4};
    check_spans_of(search, isa, (struct points){5, x, y},
                   (struct space){STANDARD, 1, 1}, "tied");
}

static inline void check_spans(span_search *search, const char *isa)
{
    check_span_generators(search, isa);
    check_span_borders(search, isa);
    check_span_shaken(search, isa);
    check_span_seams(search, isa);
    check_span_scales(search, isa);
    check_span_crowds(search, isa);
    check_span_edges(search, isa);
}
