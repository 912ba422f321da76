// Chapter 1: the tools must be right before anything is measured.
#include "algorithms.h"
#include "common/clock.h"
#include "common/count.h"
#include "common/experiment.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/geometry.h"
#include "common/random.h"
#include "common/report.h"
#include "harness.h"
#include "reader.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { draws = 100000 };

// ---- random numbers ------------------------------------------------
// The first outputs of the reference implementation.
static void bits_are_splitmix(void)
{
    struct random random = {1234567};
    CHECK(random_bits(&random) == 6457827717110365317u, "first");
    CHECK(random_bits(&random) == 3203168211198807973u, "second");
    CHECK(random_bits(&random) == 9817491932198370423u, "third");
}

// k-th sum of powers of a sample, divided by its size.
static double moment(const double *sample, int power)
{
    double sum = 0;
    for (int k = 0; k < draws; k++)
        sum += pow(sample[k], power);
    return sum / draws;
}

// Tolerances are about five standard errors.
static void uniform_numbers_are_uniform(void)
{
    static double sample[draws];
    struct random random = {1};
    test_seed(1);
    for (int k = 0; k < draws; k++) {
        sample[k] = random_uniform(&random);
        if (!CHECK(sample[k] >= 0 && sample[k] < 1, "%.17g in [0, 1)",
                   sample[k]))
            return;
    }
    CHECK_NEAR(0.5, moment(sample, 1), 0.005, "mean");
    CHECK_NEAR(1.0 / 3, moment(sample, 2), 0.005, "second moment");
}

static void normal_numbers_are_normal(void)
{
    static double sample[draws];
    struct random random = {2};
    int beyond = 0;
    test_seed(2);
    for (int k = 0; k < draws; k++) {
        sample[k] = random_normal(&random);
        beyond += fabs(sample[k]) > 1.959964;
    }
    CHECK_NEAR(0, moment(sample, 1), 0.016, "mean");
    CHECK_NEAR(1, moment(sample, 2), 0.023, "variance");
    CHECK_NEAR(0, moment(sample, 3), 0.06, "skewness");
    CHECK_NEAR(3, moment(sample, 4), 0.16, "fourth moment");
    CHECK_NEAR(0.05, (double)beyond / draws, 0.0035,
               "share beyond 1.96 deviations");
}

static void directions_are_even(void)
{
    struct random random = {3};
    int quadrant[4] = {0}, steep = 0;
    test_seed(3);
    for (int k = 0; k < draws; k++) {
        double x, y;
        random_direction(&random, &x, &y);
        if (!CHECK_NEAR(1, x * x + y * y, 1e-15, "length"))
            return;
        quadrant[(x < 0) + 2 * (y < 0)]++;
        steep += fabs(y) > fabs(x);
    }
    for (int q = 0; q < 4; q++)
        CHECK_NEAR(0.25, (double)quadrant[q] / draws, 0.007,
                   "share of quadrant %d", q);
    CHECK_NEAR(0.5, (double)steep / draws, 0.008, "steep ones");
}

// ---- generators ----------------------------------------------------
static struct points make(const char *name, uint32_t n, uint64_t seed)
{
    test_seed(seed);
    return generate(find_distribution(name), n, seed);
}

static void generators_repeat_themselves(void)
{
    for (int d = 0; d < distribution_count; d++) {
        const struct distribution *distribution = &distributions[d];
        struct points a = generate(distribution, 100, 9);
        struct points b = generate(distribution, 100, 9);
        struct points c = generate(distribution, 100, 10);
        size_t size = 100 * sizeof *a.x;
        CHECK(!memcmp(a.x, b.x, size) && !memcmp(a.y, b.y, size),
              "%s: the same seed, the same points", distribution->name);
        const char *name = distribution->name;
        bool seedless = strcmp(name, "lattice") == 0 ||
                        strcmp(name, "geometric") == 0 ||
                        strcmp(name, "doubled") == 0;
        CHECK(seedless == !memcmp(a.x, c.x, size),
              "%s: other seeds, other points", distribution->name);
        points_free(&a);
        points_free(&b);
        points_free(&c);
    }
    CHECK(!find_distribution("gauss"), "a name that is not there");
}

// The same on every machine: to the last bit, as first drawn.
static void generators_do_not_change(void)
{
    static const struct {
        const char *name;
        double x, y; // of the third point
    } drawn[] = {
        {"uniform", 0x1.c6ed53634406cp-2, 0x1.869a17ff202ap-1},
        {"clustered", 0x1.4444061e2913p-1, 0x1.caa03fc9e282bp-1},
        {"kuzmin", 0x1.dca9e7260dbeap-1, -0x1.36d549e14cf4fp-2},
    };
    for (int k = 0; k < 3; k++) {
        struct points p = make(drawn[k].name, 3, 1);
        CHECK_DOUBLE(drawn[k].x, p.x[2], "x of %s", drawn[k].name);
        CHECK_DOUBLE(drawn[k].y, p.y[2], "y of %s", drawn[k].name);
        points_free(&p);
    }
}

static void most_generators_keep_to_the_square(void)
{
    static const char *names[] = {"uniform",      "lattice",
                                  "circle",       "equal",
                                  "two-clusters", "collinear"};
    for (int k = 0; k < 6; k++) {
        struct points p = make(names[k], draws, 4);
        double x0 = 1, x1 = 0, y0 = 1, y1 = 0;
        for (uint32_t i = 0; i < p.n; i++) {
            x0 = fmin(x0, p.x[i]), x1 = fmax(x1, p.x[i]);
            y0 = fmin(y0, p.y[i]), y1 = fmax(y1, p.y[i]);
        }
        CHECK(x0 >= 0 && x1 <= 1 && y0 >= 0 && y1 <= 1, "%s: [%g, %g]",
              names[k], fmin(x0, y0), fmax(x1, y1));
        if (strcmp(names[k], "equal") != 0)
            CHECK(x1 - x0 > 0.5 && y1 - y0 > 0.4, "%s: it fills it",
                  names[k]);
        points_free(&p);
    }
}

// The lattice's points and their differences are exact: every inner
// point has four nearest neighbors at the very same distance.
static void lattice_ties_exactly(void)
{
    struct points p = make("lattice", 49, 1);
    uint32_t middle = 24, ties = 0;
    double step2 = distance2(p.x[25] - p.x[24], 0);
    for (uint32_t j = 0; j < p.n; j++)
        ties += distance2(p.x[middle] - p.x[j], p.y[middle] - p.y[j]) ==
                step2;
    CHECK_INT(4, ties, "nearest neighbors of the middle");
    CHECK_NEAR(1.0 / 49, step2, 1e-9, "squared step");
    points_free(&p);
}

static void circle_is_round(void)
{
    struct points p = make("circle", 1000, 5);
    for (uint32_t i = 0; i < p.n; i++)
        CHECK_NEAR(0.25, distance2(p.x[i] - 0.5, p.y[i] - 0.5), 1e-15,
                   "squared radius of point %u", (unsigned)i);
    points_free(&p);
}

// The share of points within r is 1 - 1 / sqrt(1 + r^2).
static void kuzmin_has_its_mass(void)
{
    struct points p = make("kuzmin", draws, 6);
    for (double r = 0.5; r < 100; r *= 2) {
        int within = 0;
        for (uint32_t i = 0; i < p.n; i++)
            within += distance2(p.x[i], p.y[i]) <= r * r;
        CHECK_NEAR(1 - 1 / sqrt(1 + r * r), (double)within / draws,
                   0.008, "mass within %g", r);
    }
    points_free(&p);
}

static void clusters_have_their_scale(void)
{
    struct points p = make("two-clusters", draws, 7);
    double sum = 0, sum2 = 0;
    int count = 0;
    for (uint32_t i = 0; i < p.n; i++)
        if (p.x[i] < 0.5) {
            sum += p.x[i];
            sum2 += (p.x[i] - 0.1) * (p.x[i] - 0.1);
            count++;
        }
    CHECK_NEAR(0.5, (double)count / draws, 0.008, "the lower cluster");
    CHECK_NEAR(0.1, sum / count, 3e-5, "its center");
    CHECK_NEAR(1e-6, sum2 / count, 4e-8, "its variance");
    points_free(&p);
}

// The ten centers are the first numbers drawn. No point is further from
// the nearest center than from its own, of which it is 2 * 0.1^2 away
// in the mean of the squares; evenly spread points would be 0.03.
static void clusters_are_around_their_centers(void)
{
    struct points p = make("clustered", draws, 7);
    struct random random = {7};
    double centers[10][2], sum2 = 0;
    int members[10] = {0};
    for (int c = 0; c < 10; c++)
        for (int axis = 0; axis < 2; axis++)
            centers[c][axis] = random_uniform(&random);
    for (uint32_t i = 0; i < p.n; i++) {
        int own = 0;
        double best2 = INFINITY;
        for (int c = 0; c < 10; c++) {
            double to2 = distance2(p.x[i] - centers[c][0],
                                   p.y[i] - centers[c][1]);
            if (to2 < best2)
                own = c, best2 = to2;
        }
        sum2 += best2;
        members[own]++;
    }
    CHECK_NEAR(0.016, sum2 / draws, 0.004, "mean squared offset");
    for (int c = 0; c < 10; c++)
        CHECK_NEAR(0.1, (double)members[c] / draws, 0.06,
                   "share of cluster %d", c);
    points_free(&p);
}

static void collinear_points_are(void)
{
    struct points p = make("collinear", 1000, 8);
    for (uint32_t i = 0; i < p.n; i++)
        CHECK_NEAR(0.25 + p.x[i] / 2, p.y[i], 1e-15, "point %u",
                   (unsigned)i);
    points_free(&p);
}

// ---- geometry ------------------------------------------------------
// Against the images themselves: a box on every side.
static void images_are_the_right_ones(void)
{
    struct space box = {WRAPAROUND, 2, 0.5};
    struct random random = {11};
    test_seed(11);
    for (int k = 0; k < 1000; k++) {
        double dx = box.width * (random_uniform(&random) * 2 - 1);
        double dy = box.height * (random_uniform(&random) * 2 - 1);
        double least = INFINITY, most = 0;
        for (int column = -1; column <= 1; column++)
            for (int row = -1; row <= 1; row++) {
                double x = dx + column * box.width;
                double y = dy + row * box.height;
                least = fmin(least, distance2(x, y));
                if (fabs(x) <= box.width && fabs(y) <= box.height)
                    most = fmax(most, distance2(x, y));
            }
        CHECK_NEAR(least, closest2(box, dx, dy), 1e-12, "closest");
        CHECK_NEAR(most, furthest2(box, dx, dy), 1e-12, "furthest");
        CHECK_DOUBLE(closest2(box, dx, dy), closest2(box, -dx, -dy),
                     "closest, the other way");
        CHECK_DOUBLE(furthest2(box, dx, dy), furthest2(box, -dx, -dy),
                     "furthest, the other way");
    }
}

static void known_distances(void)
{
    struct space plain = {STANDARD, 1, 1}, box = {WRAPAROUND, 1, 1};
    CHECK_DOUBLE(25, closest2(plain, 3, -4), "closest, standard");
    CHECK_DOUBLE(25, furthest2(plain, -3, 4), "furthest, standard");
    CHECK_DOUBLE(0.125, closest2(box, 0.75, 0.25), "closest image");
    CHECK_DOUBLE(1.125, furthest2(box, 0.75, -0.25), "furthest image");
    CHECK_DOUBLE(0, closest2(box, 0, 1), "the same point again");
    CHECK_DOUBLE(2, furthest2(box, 0, 0), "the same point, far away");
}

// ---- clock and summary ---------------------------------------------
static void quartiles_interpolate(void)
{
    double even[] = {4, 1, 3, 2}, odd[] = {5, 3, 1, 2, 4}, one[] = {7};
    struct summary s = summarize(even, 4);
    CHECK_DOUBLE(1, s.min, "least of four");
    CHECK_DOUBLE(1.75, s.q1, "first quartile of four");
    CHECK_DOUBLE(2.5, s.median, "median of four");
    CHECK_DOUBLE(3.25, s.q3, "third quartile of four");
    CHECK_DOUBLE(4, s.max, "greatest of four");
    s = summarize(odd, 5);
    CHECK_DOUBLE(2, s.q1, "first quartile of five");
    CHECK_DOUBLE(3, s.median, "median of five");
    CHECK_DOUBLE(4, s.q3, "third quartile of five");
    s = summarize(one, 1);
    CHECK(s.min == 7 && s.q1 == 7 && s.median == 7 && s.q3 == 7 &&
              s.max == 7,
          "a single value");
}

static void count_call(void *context)
{
    ++*(int *)context;
}

static void trials_run_as_often_as_said(void)
{
    int calls[2] = {0};
    struct trial versions[] = {
        {.work = count_call, .context = calls},
        {.work = count_call, .context = calls + 1}};
    time_in_turn(5, versions, 2);
    CHECK_INT(6, calls[0], "warm-up and trials of the first");
    CHECK_INT(6, calls[1], "warm-up and trials of the second");
    CHECK(versions[1].summary.min >= 0 &&
              versions[1].summary.min <= versions[1].summary.max,
          "times in order");
}

static void clock_runs_forward(void)
{
    int64_t last = clock_ns();
    for (int k = 0; k < 10000; k++) {
        int64_t now = clock_ns();
        if (!CHECK(now >= last, "%lld after %lld", (long long)now,
                   (long long)last))
            return;
        last = now;
    }
}

// ---- arguments of experiments ---------------------------------------
static void ask_for_rows(void *text)
{
    char *argv[] = {"climb", text};
    struct experiment e = {2, 1, argv};
    parameter(&e, "ROWS", 512, 8, 100);
}

static void arguments_are_whole_numbers(void)
{
    char *argv[] = {"climb", "2e4", "8", "100"};
    struct experiment e = {4, 1, argv};
    CHECK_INT(20000, parameter(&e, "POINTS", 5, 2, MANY), "2e4");
    CHECK_INT(8, parameter(&e, "ROWS", 5, 8, 100), "the least");
    CHECK_INT(100, parameter(&e, "ROWS", 5, 8, 100), "the most");
    CHECK_INT(5, parameter(&e, "TRIALS", 5, 1, 9), "left out");
    CHECK_INT(100, parameter(&e, "ROWS", 512, 8, 100),
              "left out, and cut down to the most");
}

static void ask_for_less(void *text)
{
    char *argv[] = {"climb", text};
    struct experiment e = {2, 1, argv};
    print_header(&e, "name ns:3");
}

static void bad_arguments_are_refused(void)
{
    CHECK_FAILS("test: expected no more arguments, found \"5\"\n",
                ask_for_less, "5", "one too many");
    static char *const bad[] = {
        "101", "7",   "0",   "-8",  "9.5", "5000000000", "",
        "ten", "10x", "1 0", "nan", "inf", "-inf"};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        char sentence[80];
        snprintf(sentence, sizeof sentence,
                 "test: expected ROWS from 8 to 100, found \"%s\"\n",
                 bad[k]);
        CHECK_FAILS(sentence, ask_for_rows, bad[k], "\"%s\"", bad[k]);
    }
}

// ---- memory, failing, provenance -----------------------------------
static void memory_is_aligned(void)
{
    for (uint32_t n = 1; n < 40; n++) {
        struct points p = points_allocate(n);
        CHECK_INT(0, (uintptr_t)p.x % 64, "x of %u", (unsigned)n);
        CHECK_INT(0, (uintptr_t)p.y % 64, "y of %u", (unsigned)n);
        CHECK(p.y >= p.x + n, "x and y of %u do not overlap",
              (unsigned)n);
        points_free(&p);
        CHECK(!p.n && !p.x && !p.y, "freed");
    }
}

static void ask_for_too_much(void *size)
{
    free(allocate(SIZE_MAX / 2, *(size_t *)size));
}

static void wash_up(void)
{
    fprintf(stderr, "(clean)");
}

static void fail_with_cleanup(void *context)
{
    (void)context;
    fail_as("prog");
    atexit(wash_up);
    fail("no %s for %d", "luck", 3);
}

static void failing_says_why(void)
{
    size_t one = 1, many = 16;
    CHECK_FAILS("test: no memory for 9223372036854775",
                ask_for_too_much, &one, "half of all addresses");
    CHECK_FAILS("test: 9223372036854775807 times 16 bytes",
                ask_for_too_much, &many, "a product that overflows");
    CHECK_FAILS("prog: no luck for 3\n(clean)", fail_with_cleanup, NULL,
                "fail");
}

static void provenance_is_complete(void)
{
    char text[4096] = "";
    FILE *file = fmemopen(text, sizeof text, "w");
    report_provenance(file);
    fclose(file);
    int lines = 0;
    for (char *line = strtok(text, "\n"); line;
         line = strtok(NULL, "\n"), lines++)
        CHECK(line[0] == '#' && strchr(line, ':')[2], "\"%s\"", line);
    CHECK(lines >= 6, "%d lines", lines);
}

int main(void)
{
    return RUN_TESTS(
        "ch01-workbench", TEST(bits_are_splitmix),
        TEST(uniform_numbers_are_uniform),
        TEST(normal_numbers_are_normal), TEST(directions_are_even),
        TEST(generators_repeat_themselves),
        TEST(generators_do_not_change),
        TEST(most_generators_keep_to_the_square),
        TEST(lattice_ties_exactly), TEST(circle_is_round),
        TEST(kuzmin_has_its_mass), TEST(clusters_have_their_scale),
        TEST(clusters_are_around_their_centers),
        TEST(collinear_points_are), TEST(images_are_the_right_ones),
        TEST(known_distances), TEST(quartiles_interpolate),
        TEST(trials_run_as_often_as_said), TEST(clock_runs_forward),
        TEST(arguments_are_whole_numbers),
        TEST(bad_arguments_are_refused), TEST(memory_is_aligned),
        TEST(failing_says_why), TEST(provenance_is_complete),
        TEST(good_tables_are_read), TEST(good_tsplib_files_are_read),
        TEST(bad_tables_are_refused),
        TEST(bad_tsplib_files_are_refused),
        TEST(no_file_at_all_is_refused),
        TEST(the_first_bad_line_is_named), TEST(many_points_are_read),
        TEST(numbers_survive), TEST(extreme_numbers_survive),
        TEST(numbers_are_short), TEST(both_ways_read_alike));
}
