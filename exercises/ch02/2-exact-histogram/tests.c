// Tests of the histogram: counts against a search by halves in a list
// of the edges, with values on the edges and as close below them as can
// be; and for many bins the time, against one division for each value.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>

struct range {
    double low, high;
    int bins;
};

static const struct range ranges[] = {
    {0, 1, 10}, {0, 1, 49},      {0, 1.5, 100},
    {-1, 1, 7}, {0.1, 0.7, 333}, {1e-5, 3e-5, 60},
};
static const int range_count = sizeof ranges / sizeof *ranges;

// A search edge by edge takes thousands of divisions here, one by
// halves dozens.
static const struct range many_bins = {-0.3, 2.1, 5000};
enum { DIVISIONS = 300 };

static double edge_of(struct range r, int b)
{
    return edge(r.low, r.high, r.bins, b);
}

// -1: in no bin. The first edge may lie a rounding beside low.
static int bin_of(struct range r, double value)
{
    if (!(value >= r.low && value <= r.high))
        return -1;
    int from = 0, to = r.bins;
    while (to - from > 1) {
        int middle = from + (to - from) / 2;
        if (edge_of(r, middle) <= value)
            from = middle;
        else
            to = middle;
    }
    return from;
}

// Why there is a count too many, or one is missing, in bin b; bin -1
// is the outside.
static const char *cause(const double *values, size_t n, struct range r,
                         int b, bool too_many)
{
    if (b >= 0 && too_many)
        for (size_t i = 0; i < n; i++) {
            if (isnan(values[i]))
                return "NaN is in no bin, but every comparison with it "
                       "is false: ask whether a value is inside.";
            if (b == 0 && values[i] < r.low)
                return "A value just below the range was counted: "
                       "(int) rounds toward zero.";
        }
    if (b == r.bins - 1 || b < 0)
        for (size_t i = 0; i < n; i++)
            if (values[i] == r.high)
                return kit_text("The value %g itself belongs to the "
                                "last bin.",
                                r.high);
    if (b < 0)
        return "Only what is below the range, above it, or no number "
               "lies outside.";
    return "A quotient was rounded to the other side of an edge, or "
           "the range was not mapped onto the bins: compare with "
           "edge() after dividing.";
}

static void check(double *values, size_t n, struct range r)
{
    kit_given("%zu values, %d bins from %g to %g", n, r.bins, r.low,
              r.high);
    uint64_t *counts = kit_output("counts", r.bins, sizeof *counts);
    size_t *outside = kit_output("the result", 1, sizeof *outside);
    CALL(*outside = STUDENT(histogram)(values, n, r.low, r.high, r.bins,
                                       counts));
    size_t right_outside = 0;
    uint64_t *right = kit_input("right", r.bins, sizeof *right);
    for (int b = 0; b < r.bins; b++)
        right[b] = 0;
    for (size_t i = 0; i < n; i++) {
        int b = bin_of(r, values[i]);
        if (b < 0)
            right_outside++;
        else
            right[b]++;
    }
    for (int b = 0; b < r.bins; b++)
        if (counts[b] != right[b])
            WRONG(.where = kit_text("bin %d, from %.17g to %.17g", b,
                                    edge_of(r, b), edge_of(r, b + 1)),
                  .expected = kit_text("%ju", (uintmax_t)right[b]),
                  .found = kit_text("%ju", (uintmax_t)counts[b]),
                  .cause = counts[b] > 1000000000
                               ? "The counts must be set to 0 first: "
                                 "what the array held before counts "
                                 "for nothing."
                               : cause(values, n, r, b,
                                       counts[b] > right[b]));
    if (*outside != right_outside)
        WRONG(.where = "the result, the number of values in no bin",
              .expected = kit_text("%zu", right_outside),
              .found = kit_text("%zu", *outside),
              .cause =
                  cause(values, n, r, -1, *outside > right_outside));
}

static volatile double divided; // keeps the divisions

static void divide(const double *values, size_t n, int rounds)
{
    struct range r = many_bins;
    for (int k = 0; k < rounds; k++)
        for (size_t i = 0; i < n; i++)
            divided = (values[i] - r.low) / (r.high - r.low) * r.bins;
}

// The seconds of so many divisions for each value, and of the CALL
// around them, which alone takes as long as dozens: the fastest counts.
static double seconds_of(const double *values, size_t n, int rounds)
{
    enum { TRIALS = 3 };
    double best = INFINITY;
    for (int trial = 0; trial < TRIALS; trial++) {
        CALL(divide(values, n, rounds));
        best = fmin(best, kit_seconds(false));
    }
    return best;
}

// The counts of many values, and the time in divisions. One that is too
// long may have been an accident.
static void check_in_time(double *values, size_t n)
{
    enum { ROUNDS = 300, TRIALS = 3 };
    int trials = kit_is_sanitized() ? 1 : TRIALS;
    double call = seconds_of(values, n, 0);
    double division = (seconds_of(values, n, ROUNDS) - call) / ROUNDS;
    double divisions = INFINITY;
    for (int t = 0; t < trials && divisions > DIVISIONS; t++) {
        check(values, n, many_bins);
        divisions =
            fmin(divisions, (kit_seconds(false) - call) / division);
    }
    if (divisions > DIVISIONS && !kit_is_sanitized())
        WRONG(.expected = "a time like that of a division or two for "
                          "each value",
              .found = kit_text("that of %.0f", divisions),
              .cause = "Are the edges searched, one by one? A division "
                       "tells the bin, or the one beside it.");
    kit_next_case();
}

// As many values as a time takes, at the edge of every bin.
static void check_at_edges(bool below)
{
    enum { ROUNDS = 16 };
    size_t bins = many_bins.bins, n = ROUNDS * bins;
    double *values = kit_input("values", n, sizeof *values);
    for (size_t i = 0; i < n; i++) {
        int b = i % bins;
        values[i] =
            below ? nextafter(edge_of(many_bins, b + 1), many_bins.low)
                  : edge_of(many_bins, b);
    }
    check_in_time(values, n);
}

static void middles(uint64_t seed)
{
    (void)seed;
    for (int k = 0; k < range_count; k++) {
        struct range r = ranges[k];
        double *values = kit_input("values", r.bins, sizeof *values);
        for (int b = 0; b < r.bins; b++)
            values[b] = (edge_of(r, b) + edge_of(r, b + 1)) / 2;
        check(values, r.bins, r);
        kit_next_case();
    }
}

static void on_edges(uint64_t seed)
{
    (void)seed;
    for (int k = 0; k < range_count; k++) {
        struct range r = ranges[k];
        double *values = kit_input("values", r.bins, sizeof *values);
        for (int b = 0; b < r.bins; b++)
            values[b] = edge_of(r, b);
        check(values, r.bins, r);
        kit_next_case();
    }
    check_at_edges(false);
}

static void below_edges(uint64_t seed)
{
    (void)seed;
    for (int k = 0; k < range_count; k++) {
        struct range r = ranges[k];
        double *values = kit_input("values", r.bins, sizeof *values);
        for (int b = 0; b < r.bins; b++)
            values[b] = nextafter(edge_of(r, b + 1), r.low);
        check(values, r.bins, r);
        kit_next_case();
    }
    check_at_edges(true);
}

static void one_value(double value, int copies)
{
    struct range r = {0, 1, 10};
    double *values = kit_input("values", copies, sizeof *values);
    for (int i = 0; i < copies; i++)
        values[i] = value;
    check(values, copies, r);
    kit_next_case();
}

static void highest(uint64_t seed)
{
    (void)seed;
    one_value(1, 3);
}

static void outside(uint64_t seed)
{
    (void)seed;
    one_value(-0.05, 3);
    one_value(nextafter(0, -1), 1);
    one_value(nextafter(1, 2), 2);
    one_value(-INFINITY, 1);
    one_value(INFINITY, 1);
    one_value(0.5, 0);
}

static void not_numbers(uint64_t seed)
{
    (void)seed;
    one_value(NAN, 3);
}

static double *draw(struct range r, size_t n, uint64_t seed)
{
    struct random random = {seed};
    double *values = kit_input("values", n, sizeof *values);
    for (size_t i = 0; i < n; i++)
        values[i] = r.low - 0.1 * (r.high - r.low) +
                    1.2 * (r.high - r.low) * random_uniform(&random);
    return values;
}

static void many(uint64_t seed)
{
    for (int k = 0; k < range_count; k++) {
        check(draw(ranges[k], 20000, seed + k), 20000, ranges[k]);
        kit_next_case();
    }
    check_in_time(draw(many_bins, 80000, seed), 80000);
}

const struct kit_test kit_tests[] = {
    {"middles", 1, "values in the middle of a bin", middles},
    {"on-edges", 2, "values on an edge, without a search", on_edges},
    {"below-edges", 2, "values just below an edge, likewise",
     below_edges},
    {"highest", 1, "the highest value", highest},
    {"outside", 1, "values outside, or none at all", outside},
    {"not-numbers", 1, "NaN", not_numbers},
    {"many", 2, "many values, inside and outside, likewise", many},
    {0},
};
