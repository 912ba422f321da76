// The furthest point: by cells and by corners, against the plainest
// search there is, on points that are meant to hurt them; as many
// corners, cells and distances as were expected; and tricks that must
// be wrong where the book says so.
#include "algorithms.h"
#include "ch10-furthest/check_furthest.h"
#include "ch10-furthest/coursework_furthest.h"
#include "ch10-furthest/experiments/expected_far.h"
#include "ch10-furthest/furthest_branch_and_bound.h"
#include "ch10-furthest/furthest_cells.h"
#include "ch10-furthest/hull.h"
#include "common/generate.h"
#include "common/isa.h"
#include "common/random.h"
#include "harness.h"
#include "memory.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- the answers ---------------------------------------------------
static struct question ask(struct points points, enum geometry geometry,
                           int threads)
{
    double x0 = 0, y0 = 0, x1 = 1, y1 = 1;
    for (uint32_t i = 0; i < points.n; i++) {
        x0 = fmin(x0, points.x[i]), x1 = fmax(x1, points.x[i]);
        y0 = fmin(y0, points.y[i]), y1 = fmax(y1, points.y[i]);
    }
    return (struct question){
        points, {geometry, x1 - x0, y1 - y0}, threads};
}

// How many points have another furthest, or another distance to it.
static uint32_t count_wrong(const struct answers *right,
                            const struct answers *found, uint32_t n)
{
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < n; i++)
        wrong += right->furthest2[i] != found->furthest2[i] ||
                 right->furthest[i] != found->furthest[i];
    return wrong;
}

static void check_far(const char *name, struct points points)
{
    static const char *const rows[] = {"furthest-cells",
                                       "furthest-hull", "near-and-far"};
    struct answers right = answers_allocate(points.n);
    struct answers found = answers_for(points.n, FURTHEST);
    for (int g = STANDARD; g <= WRAPAROUND; g++) {
        struct question question = ask(points, g, 1);
        search_plainly(&question, &right);
        for (int threads = 1; threads <= 4; threads *= 2)
            for (int row = 0; row < 3; row++) {
                const struct algorithm *a = find_algorithm(rows[row]);
                if (!(a->geometries & g))
                    continue;
                question.threads = threads;
                memset(found.furthest, 0xA5, points.n * 4);
                a->run(&question, &found);
                CHECK_INT(0, count_wrong(&right, &found, points.n),
                          "%s, %u %s points, geometry %d, %d threads",
                          rows[row], points.n, name, g, threads);
            }
    }
    answers_free(&found);
    answers_free(&right);
}

static void check_generated(uint32_t n)
{
    for (int d = 0; d < distribution_count; d++) {
        test_seed(n);
        struct points points = generate(&distributions[d], n, n);
        check_far(distributions[d].name, points);
        points_free(&points);
    }
}

// All pairs of them are compared, for every generator.
static uint32_t longest(void)
{
    return at_most("MOST_POINTS", 30000) / 10;
}

static void every_generator(void)
{
    static const uint32_t lengths[] = {2,   3,   4,   7,    8,   9,
                                       255, 256, 257, 1000, 3000};
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++)
        if (lengths[k] <= longest())
            check_generated(lengths[k]);
}

// Moves and stretches the points: all that is small against the offset
// is rounded away.
static void check_moved(const char *name, double scale, double x,
                        double y)
{
    for (int d = 0; d < distribution_count; d++) {
        struct points points = generate(&distributions[d], 400, 5);
        char what[100];
        snprintf(what, sizeof what, "%s %s", name,
                 distributions[d].name);
        for (uint32_t i = 0; i < points.n; i++) {
            points.x[i] = x + scale * points.x[i];
            points.y[i] = y + scale * points.y[i];
        }
        check_far(what, points);
        points_free(&points);
    }
}

static void moved_and_stretched(void)
{
    check_moved("far off", 1, 1e8, -1e8);
    check_moved("very far off", 1, 1e15, 3e15);
    check_moved("far off to the right", 1, 1e16, 0);
    check_moved("tiny", 1e-150, 0, 0);
    check_moved("vanishing", 1e-161, 0, 0);
    check_moved("hardly there", 1e-310, 0, 0);
    check_moved("huge", 1e150, -5e149, 0);
    check_moved("overflowing", 1e154, 0, 0);
    check_moved("beyond all bounds", 1e297, 0, 0);
}

// ---- shapes that hurt ----------------------------------------------
static double pick(struct random *random, int steps)
{
    return (double)(random_bits(random) % steps) / steps;
}

// Shape 0: a slanted line, off by the last bits; 1: a cross of the
// diagonals; 2: two crowds, each nearly a point; 3: a circle, off by
// the last bits; 4: a circle and its center, many times; 5: few
// places, each many times; 6: a box without one of its corners; 7: a
// line upright, one point beside it.
enum { SHAPES = 8 };

static void place(int shape, struct random *random, uint32_t i,
                  double *x, double *y)
{
    double a = random_uniform(random), b = random_uniform(random);
    random_direction(random, x, y);
    switch (shape) {
    case 0:
        *x = a, *y = a / 3 + (pick(random, 8) - 0.5) * 0x1p-51;
        break;
    case 1:
        *x = a, *y = i % 2 ? a : 1 - a;
        break;
    case 2:
        *x = i % 2 + 1e-9 * a, *y = i % 2 + 1e-9 * b;
        break;
    case 3:
        *x += (pick(random, 8) - 0.5) * 0x1p-51;
        break;
    case 4:
        if (i % 2)
            *x = *y = 0;
        break;
    case 5:
        *x = pick(random, 3), *y = pick(random, 3);
        break;
    case 6:
        while (a + b > 1.6)
            a = random_uniform(random), b = random_uniform(random);
        *x = a, *y = b;
        break;
    default:
        *x = i == 5 ? 1e-12 : 0, *y = a;
    }
}

static struct points shaped(int shape, uint32_t n, uint64_t seed)
{
    struct random random = {seed};
    struct points points = points_allocate(n);
    for (uint32_t i = 0; i < n; i++)
        place(shape, &random, i, &points.x[i], &points.y[i]);
    return points;
}

static void shapes_that_hurt(void)
{
    static const uint32_t lengths[] = {2, 3, 5, 20, 200, 2000};
    for (int shape = 0; shape < SHAPES; shape++)
        for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) {
            char name[20];
            snprintf(name, sizeof name, "shape %d", shape);
            test_seed(k);
            struct points points = shaped(shape, lengths[k], k);
            check_far(name, points);
            points_free(&points);
        }
}

// Each query alone, in whatever order.
static void search_alone(const struct question *question,
                         const struct partition *partition,
                         struct workspace *workspace,
                         struct answers *found)
{
    const struct sorted *sorted = &partition->sorted;
    struct mark mark = workspace_mark(workspace);
    const struct rows rows = rows_find(sorted, workspace);
    const struct far_scene scene = {sorted, &rows, question->space};
    struct counts counts = {0};
    for (uint32_t s = 0; s < sorted->points.n; s++) {
        const uint32_t i = sorted->cells.point[s];
        struct neighbor far;
        furthest_of_one(&scene, s, &far, &counts);
        found->furthest[i] = far.index;
        found->furthest2[i] = far.distance2;
    }
    counts_add(question->counts, &counts);
    workspace_release(workspace, mark);
}

// Eight that follow each other, at every place of rows of all lengths,
// chunks that end within eight, and threads: in batches or alone, each
// query has its own answer.
static void check_modes(struct points points, double c)
{
    struct workspace workspace = {0};
    struct answers right = answers_allocate(points.n);
    struct answers found = answers_for(points.n, FURTHEST);
    for (int g = STANDARD; g <= WRAPAROUND; g++) {
        struct question question = ask(points, g, 2);
        const struct mark mark = workspace_mark(&workspace);
        struct partition partition =
            partition_make(&question, c, RESTORE, &workspace);
        search_plainly(&question, &right);
        for (int alone = 0; alone <= 1; alone++) {
            memset(found.furthest, 0xA5, points.n * 4);
            memset(found.furthest2, 0xA5, points.n * 8);
            if (alone)
                search_alone(&question, &partition, &workspace, &found);
            else
                search_furthest_cells(&question, &partition, &workspace,
                                      &found);
            CHECK_INT(0, count_wrong(&right, &found, points.n),
                      "%u points, geometry %d, %g in a cell, alone %d",
                      points.n, g, c, alone);
        }
        workspace_release(&workspace, mark);
    }
    workspace_free(&workspace);
    answers_free(&found);
    answers_free(&right);
}

static void rows_of_all_lengths(void)
{
    static const double fullness[] = {0.1, 0.5, 2, 7, 40};
    for (uint32_t n = 2; n <= 700; n += n < 40 ? 1 : 61)
        for (int k = 0; k < 5; k++)
            for (int d = 0; d < 3; d++) {
                struct points points =
                    generate(&distributions[d], n, n);
                test_seed(n);
                check_modes(points, fullness[k]);
                points_free(&points);
            }
}

// A coordinate for a file of cities: few digits, thousands of ties.
static void few_digits(void)
{
    struct random random = {3};
    struct points points = points_allocate(3000);
    test_seed(3);
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] =
            -180 + floor(36000 * random_uniform(&random)) / 100;
        points.y[i] = 40 + floor(900 * random_uniform(&random)) / 100;
    }
    check_far("few digits", points);
    points_free(&points);
}

// ---- wraparound, by tiles ------------------------------------------
// Both halves, and either without the other.
static void check_halves(const char *name,
                         const struct question *question)
{
    const uint32_t n = question->points.n;
    struct answers right = answers_allocate(n);
    struct answers found = answers_allocate(n);
    struct answers half;
    search_plainly(question, &right);
    for (int halves = NEAREST; halves <= (NEAREST | FURTHEST);
         halves++) {
        half = found;
        memset(found.nearest, 0xA5, n * 4);
        memset(found.furthest, 0xA5, n * 4);
        if (!(halves & NEAREST))
            half.nearest = NULL, half.nearest2 = NULL;
        if (!(halves & FURTHEST))
            half.furthest = NULL, half.furthest2 = NULL;
        find_algorithm("near-and-far")->run(question, &half);
        uint32_t wrong = 0;
        for (uint32_t i = 0; i < n; i++)
            wrong += (half.nearest &&
                      (right.nearest[i] != found.nearest[i] ||
                       right.nearest2[i] != found.nearest2[i])) ||
                     (half.furthest &&
                      (right.furthest[i] != found.furthest[i] ||
                       right.furthest2[i] != found.furthest2[i]));
        CHECK_INT(0, wrong, "%u %s points, halves %d, geometry %d", n,
                  name, halves, question->space.geometry);
    }
    answers_free(&found);
    answers_free(&right);
}

static void halves_left_out(void)
{
    for (int g = STANDARD; g <= WRAPAROUND; g++)
        for (int d = 0; d < distribution_count; d++)
            for (int seed = 1; seed <= 2; seed++) {
                struct points points =
                    generate(&distributions[d],
                             at_most("MOST_POINTS", 25000) / 10, seed);
                struct question question = ask(points, g, seed);
                test_seed(seed);
                check_halves(distributions[d].name, &question);
                points_free(&points);
            }
}

// Boxes of all shapes; points anywhere in them, on a lattice, on two
// sides or on all four, twice each, or in one corner.
enum { SORTS = 6 };

static struct points in_box(int sort, uint32_t n, double width,
                            double height, struct random *random)
{
    struct points points = points_allocate(n);
    for (uint32_t i = 0; i < n; i++) {
        double a = random_uniform(random), b = random_uniform(random);
        if (sort == 1)
            a = pick(random, 16), b = pick(random, 16);
        if (sort == 2)
            a = i % 2;
        if (sort == 3)
            *(i % 2 ? &a : &b) = i / 2 % 2;
        if (sort == 4 && i % 2)
            a = points.x[i - 1] / width, b = points.y[i - 1] / height;
        if (sort == 5)
            a /= 8, b /= 8;
        points.x[i] = a * width;
        points.y[i] = b * height;
    }
    return points;
}

static void check_boxes(uint32_t n, uint32_t cases)
{
    static const double sides[] = {1,       3,     1e-3,   1e5,
                                   0x1p-30, 1e-20, 1e-150, 1e-310,
                                   0x1p49,  1e20,  1e150,  1e300};
    enum { SIDES = sizeof sides / sizeof *sides };
    struct random random = {n};
    if (n > longest())
        cases /= 10;
    for (uint32_t k = 0; k < cases; k++) {
        double width = sides[random_bits(&random) % SIDES];
        double height = random_bits(&random) % 4
                            ? width * (0.25 + random_uniform(&random))
                            : sides[random_bits(&random) % SIDES];
        int sort = random_bits(&random) % SORTS;
        struct points points = in_box(sort, n, width, height, &random);
        struct question question = {
            points, {WRAPAROUND, width, height}, 1 + k % 2};
        test_seed(n);
        check_halves("boxed", &question);
        points_free(&points);
    }
}

static void boxes_of_all_shapes(void)
{
    for (uint32_t n = 2; n <= 60; n++)
        check_boxes(n, 60);
    check_boxes(150, 200);
    check_boxes(400, 200);
    check_boxes(1500, 60);
}

static void check_by_cells(const char *name,
                           const struct question *question)
{
    const uint32_t n = question->points.n;
    struct answers right = answers_allocate(n);
    struct answers found = answers_for(n, FURTHEST);
    search_plainly(question, &right);
    furthest_cells(question, &found);
    CHECK_INT(0, count_wrong(&right, &found, n), "%u %s points", n,
              name);
    answers_free(&found);
    answers_free(&right);
}

// Boxes anywhere, and points on either side of the seam, a few doubles
// apart; or the whole box is a few doubles wide. There the bounds of
// the first column and of the last are as near as they can be.
static double at_the_seam(double low, double high, bool narrow,
                          struct random *random)
{
    double x = random_bits(random) % 2 ? low : high;
    if (random_bits(random) % 4 == 0 && !narrow)
        x = low + (high - low) * random_uniform(random);
    for (uint32_t k = random_bits(random) % 8; k > 0; k--)
        x = nextafter(x, (low + high) / 2);
    return x;
}

static void over_the_seam(void)
{
    struct random random = {11};
    for (uint32_t k = 0; k < 2000; k++) {
        double low = 8 * random_uniform(&random) - 4;
        double high = low + (k % 2 ? 1e-15 : 1) *
                                (1 + 7 * random_uniform(&random));
        struct points points =
            points_allocate(2 + random_bits(&random) % 60);
        for (uint32_t i = 0; i < points.n; i++) {
            points.x[i] = at_the_seam(low, high, k % 2, &random);
            points.y[i] = at_the_seam(low, high, k % 2, &random);
        }
        struct question question = {
            points, {WRAPAROUND, high - low, high - low}, 1};
        test_seed(k);
        check_halves("seam", &question);
        check_by_cells("seam", &question);
        points_free(&points);
    }
}

static void all_instruction_sets(void)
{
    for (int isa = 0; isa < ISA_COUNT; isa++)
        if (isa_present(isa)) {
            setenv("NEAR_ISA", isa_names[isa], 1);
            check_generated(longest());
            check_boxes(1000, 60);
        }
    unsetenv("NEAR_ISA");
}

static void certified_are_right(void)
{
    check_furthest(portable_furthest, &portable_spans);
#ifdef HAVE_X86_VECTORS
    if (isa_present(AVX2))
        check_furthest(avx2_furthest, &avx2_spans);
    if (isa_present(AVX512))
        check_furthest(avx512_furthest, &avx512_spans);
#endif
}

// Evenly spread, hardly anybody has to look from outside; whoever has
// the same point twice around him always must.
static uint64_t count_alone(struct points points)
{
    struct question question = {points, {WRAPAROUND, 1, 1}, 2};
    struct answers found = answers_for(points.n, FURTHEST);
    struct counts counts = count_operations(
        find_algorithm("near-and-far"), &question, &found);
    answers_free(&found);
    return counts.exact;
}

static void few_look_from_outside(void)
{
    for (int seed = 1; seed <= 2; seed++) {
        struct points points =
            generate(find_distribution("uniform"), 100000, seed);
        uint64_t alone = count_alone(points);
        test_seed(seed);
        CHECK(300 < alone && alone < 3000, "%llu of 100,000 alone",
              (unsigned long long)alone);
        for (uint32_t i = 0; i + 2 < points.n; i += 3)
            for (uint32_t k = 1; k < 3; k++) {
                points.x[i + k] = points.x[i];
                points.y[i + k] = points.y[i];
            }
        alone = count_alone(points);
        CHECK(alone > 99000, "%llu of 100,000 with two twins",
              (unsigned long long)alone);
        points_free(&points);
    }
}

// ---- the corners ---------------------------------------------------
// Renyi and Sulanke (1963), for a square.
static double expected_corners(double n)
{
    return 8.0 / 3 * (log(n) + 0.57721566490153286 - log(2));
}

static uint32_t corners_of(struct points points)
{
    struct question question = ask(points, STANDARD, 2);
    struct workspace workspace = {0};
    struct corners corners = corners_find(&question, &workspace);
    uint32_t count = corners.points.n;
    for (uint32_t k = 0; k < count; k++) {
        uint32_t i = corners.point[k];
        CHECK(k == 0 || corners.point[k - 1] < i, "ascending");
        CHECK_DOUBLE(points.x[i], corners.points.x[k], "x of %u", k);
        CHECK_DOUBLE(points.y[i], corners.points.y[k], "y of %u", k);
    }
    workspace_free(&workspace);
    return count;
}

static void corners_as_expected(void)
{
    const uint32_t most = at_most("MOST_POINTS", 1000000);
    for (uint32_t n = 1000; n <= most; n *= 10) {
        const int sets = n < 100000 ? 40 : 5;
        double sum = 0;
        for (int seed = 0; seed < sets; seed++) {
            struct points points =
                generate(find_distribution("uniform"), n, seed);
            sum += corners_of(points);
            points_free(&points);
        }
        CHECK_NEAR(expected_corners(n), sum / sets,
                   0.2 * expected_corners(n), "corners of %u", n);
    }
}

static void corners_of_shapes(void)
{
    static const uint32_t most[SHAPES] = {200,  4, 100, 3000,
                                          3000, 4, 500, 3};
    for (int shape = 0; shape < SHAPES; shape++) {
        struct points points = shaped(shape, 3000, 1);
        uint32_t count = corners_of(points);
        CHECK(count >= 2 && count <= most[shape],
              "shape %d: %u corners", shape, count);
        points_free(&points);
    }
    struct points lattice =
        generate(find_distribution("lattice"), 10000, 1);
    CHECK_INT(4, corners_of(lattice), "corners of a lattice");
    points_free(&lattice);
}

static void corners_of_any_threads(void)
{
    struct points points =
        generate(find_distribution("circle"), 2000, 1);
    struct question question = ask(points, STANDARD, 1);
    struct workspace workspace = {0};
    struct corners one = corners_find(&question, &workspace);
    CHECK(one.points.n > 1900, "a circle has corners all over");
    for (question.threads = 2; question.threads <= 64;
         question.threads *= 2) {
        struct mark mark = workspace_mark(&workspace);
        struct corners many = corners_find(&question, &workspace);
        CHECK_INT(one.points.n, many.points.n, "%d threads",
                  question.threads);
        CHECK_INT(0, memcmp(one.point, many.point, 4 * one.points.n),
                  "%d threads: who", question.threads);
        workspace_release(&workspace, mark);
    }
    workspace_free(&workspace);
    points_free(&points);
}

// ---- counts and means ----------------------------------------------
static struct counts count_far(enum geometry geometry, bool batched,
                               uint32_t n, uint64_t seed)
{
    struct points points =
        generate(find_distribution("uniform"), n, seed);
    struct question question = {points, {geometry, 1, 1}, 2};
    struct answers found = answers_for(n, FURTHEST);
    struct workspace workspace = {0};
    struct partition partition = partition_make(
        &question, POINTS_PER_FAR_CELL, RESTORE, &workspace);
    struct counts counts = {0};
    question.counts = &counts;
    if (batched)
        search_furthest_cells(&question, &partition, &workspace,
                              &found);
    else
        search_alone(&question, &partition, &workspace, &found);
    workspace_free(&workspace);
    answers_free(&found);
    points_free(&points);
    return counts;
}

// All points of a set look at the same few corners: only several sets
// have a mean.
static void check_counts(enum geometry geometry, uint32_t n, int sets)
{
    const double c = POINTS_PER_FAR_CELL;
    const double cells = expected_outside(geometry, c);
    const double own = geometry == WRAPAROUND; // looks at himself
    const double full = own + (cells - own) * (1 - exp(-c));
    double looked = 0, asked = 0;
    for (int seed = 0; seed < sets; seed++) {
        struct counts counts = count_far(geometry, false, n, seed);
        looked += (double)counts.cells / n / sets;
        asked += (double)counts.distances / n / sets;
    }
    CHECK_NEAR(full, looked, 0.2 * full,
               "cells, geometry %d, %u points", geometry, n);
    CHECK_NEAR(c * cells + own, asked, 0.2 * (c * cells + own),
               "distances, geometry %d, %u points", geometry, n);
}

// Eight together look at what any of them wants. In the standard
// geometry, the wider the grid, the more they are of one mind; with
// wraparound home is what they look at, and they have several.
static void check_together(enum geometry geometry, uint32_t n,
                           double most)
{
    struct counts alone = count_far(geometry, false, n, 1);
    struct counts together = count_far(geometry, true, n, 1);
    double times = (double)together.distances / alone.distances;
    CHECK(1 <= times && times < most,
          "geometry %d, %u points: %g times as many distances",
          geometry, n, times);
}

static void eight_want_little_more(void)
{
    check_together(STANDARD, 10000, 1.2);
    if (at_most("MOST_POINTS", 1000000) < 1000000)
        return;
    check_together(STANDARD, 1000000, 1.03);
    check_together(WRAPAROUND, 100000, 4);
}

static void counts_as_expected(void)
{
    const uint32_t most = at_most("MOST_POINTS", 1000000);
    for (uint32_t n = 1000; n <= most; n *= 10) {
        check_counts(STANDARD, n, n < 1000000 ? 40 : 8);
        check_counts(WRAPAROUND, n, 1);
    }
}

// The coursework's, of ten sets of 100,000 points.
static void means_as_reported(void)
{
    static const double reported[] = {1.067968, 1.412812};
    const uint32_t n = 100000;
    struct points points = generate(find_distribution("uniform"), n, 2);
    struct answers found = answers_for(n, FURTHEST);
    for (int g = STANDARD; g <= WRAPAROUND; g++) {
        struct question question = {points, {g, 1, 1}, 2};
        double sum = 0;
        furthest_cells(&question, &found);
        for (uint32_t i = 0; i < n; i++)
            sum += sqrt(found.furthest2[i]);
        CHECK_NEAR(reported[g - 1], sum / n, 0.003 * reported[g - 1],
                   "mean furthest distance, geometry %d", g);
    }
    answers_free(&found);
    points_free(&points);
}

// ---- the tricks ----------------------------------------------------
typedef void sorted_search(const struct question *question,
                           const struct sorted *sorted,
                           struct answers *answers);

static uint32_t wrong_answers(struct points points,
                              sorted_search *search, double c)
{
    struct question question = ask(points, STANDARD, 2);
    struct sorted sorted = sorted_make(&question, c);
    struct answers right = answers_allocate(points.n);
    struct answers found = answers_for(points.n, FURTHEST);
    search_plainly(&question, &right);
    search(&question, &sorted, &found);
    uint32_t wrong = count_wrong(&right, &found, points.n);
    answers_free(&found);
    answers_free(&right);
    sorted_free(&sorted);
    return wrong;
}

// With so many points in a cell hardly one is empty.
static const double TRUSTED = 15;

static void tricks_that_work(void)
{
    struct points points =
        generate(find_distribution("uniform"), 5000, 1);
    test_seed(1);
    CHECK_INT(0, wrong_answers(points, search_edge_cells, TRUSTED),
              "edge cells");
    CHECK_INT(0, wrong_answers(points, search_one_corner, TRUSTED),
              "one corner");
    points_free(&points);
}

// Four points in the middles of the edges make the box; the rest are on
// the diagonals, away from all edges.
static void edge_cells_fail(void)
{
    struct random random = {1};
    struct points points = points_allocate(2000);
    for (uint32_t i = 0; i < points.n; i++) {
        double a = 0.1 + 0.8 * random_uniform(&random);
        points.x[i] = a;
        points.y[i] = i % 2 ? a : 1 - a;
    }
    points.x[0] = 0, points.x[1] = 1, points.x[2] = points.x[3] = 0.5;
    points.y[2] = 0, points.y[3] = 1, points.y[0] = points.y[1] = 0.5;
    uint32_t wrong = wrong_answers(points, search_edge_cells, 4);
    CHECK(wrong > 1000, "edge cells: only %u wrong", wrong);
    points_free(&points);
}

// One corner is cut off, so that its cell is empty: who is far from
// there may find nobody outside the circle.
static void corner_trick_fails(void)
{
    struct points points = shaped(6, 5000, 1);
    uint32_t wrong = wrong_answers(points, search_one_corner, TRUSTED);
    CHECK(wrong > 1000 && wrong < 4500, "one corner: %u wrong", wrong);
    points_free(&points);
}

static void tricks_count(void)
{
    const uint32_t n = 60000;
    const double edge = sqrt(n / TRUSTED);
    static sorted_search *const searches[] = {search_edge_cells,
                                              search_one_corner};
    const double expected[] = {4 * edge - 4, 4 + 16 / edge};
    struct points points = generate(find_distribution("uniform"), n, 1);
    struct question question = ask(points, STANDARD, 2);
    struct sorted sorted = sorted_make(&question, TRUSTED);
    struct answers found = answers_for(n, FURTHEST);
    for (int trick = 0; trick < 2; trick++) {
        double cells = expected[trick];
        struct counts counts = {0};
        question.counts = &counts;
        searches[trick](&question, &sorted, &found);
        CHECK_NEAR(cells, (double)counts.cells / n, 0.2 * cells,
                   "cells, trick %d", trick);
        CHECK_NEAR(TRUSTED * cells, (double)counts.distances / n,
                   0.2 * TRUSTED * cells, "distances, trick %d", trick);
    }
    answers_free(&found);
    sorted_free(&sorted);
    points_free(&points);
}

// ---- memory --------------------------------------------------------
static void memory_is_kept(void)
{
    check_memory_kept("near-and-far", 2, 67);
}

// ---- margins -------------------------------------------------------
// Two corners on the upper side of a box, a bit or two apart: from
// afar, rounding makes their distances equal, and then the one with the
// lower index is right, though the other is further. Without the
// margins of the hull and of the candidate grid it would have been
// thrown away.
static struct points twin_corners(struct random *random)
{
    const uint32_t n = 400;
    const double height = 1 + random_uniform(random);
    struct points points = points_allocate(n);
    for (uint32_t i = 0; i < n; i++) {
        points.x[i] = 0.5 * random_uniform(random);
        points.y[i] = 0.5 * random_uniform(random);
    }
    const double x[] = {1 - 0x1p-53, 1, 0, 1, 0};
    const double y[] = {height, height, height, 0, 0};
    memcpy(points.x, x, sizeof x);
    memcpy(points.y, y, sizeof y);
    return points;
}

static void margins_have_a_reason(void)
{
    struct random random = {5};
    for (int set = 0; set < 10; set++) {
        struct points points = twin_corners(&random);
        check_far("twin corners", points);
        points_free(&points);
    }
}

int main(void)
{
    return RUN_TESTS(
        "ch10-furthest", TEST(every_generator),
        TEST(moved_and_stretched), TEST(shapes_that_hurt),
        TEST(rows_of_all_lengths), TEST(few_digits),
        TEST(halves_left_out), TEST(boxes_of_all_shapes),
        TEST(over_the_seam), TEST(all_instruction_sets),
        TEST(certified_are_right), TEST(few_look_from_outside),
        TEST(corners_as_expected), TEST(corners_of_shapes),
        TEST(corners_of_any_threads), TEST(counts_as_expected),
        TEST(eight_want_little_more), TEST(means_as_reported),
        TEST(tricks_that_work), TEST(edge_cells_fail),
        TEST(corner_trick_fails), TEST(tricks_count),
        TEST(memory_is_kept), TEST(margins_have_a_reason));
}
