// Tests of the shortest arc: it must begin at a point, hold all points
// and be no longer than the circle without its widest gap. For many
// points the widest gap is known, since we made it, and the time is
// compared with that of a sort.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double tolerance = 1e-12;

// How far it is from a up to b.
static double up_to(double a, double b)
{
    return b >= a ? b - a : b + 1 - a;
}

// Every point is tried as the beginning: O(n^2).
static struct arc search(const double *x, uint32_t n)
{
    struct arc best = {0, 2};
    for (uint32_t i = 0; i < n; i++) {
        struct arc arc = {x[i], 0};
        for (uint32_t j = 0; j < n; j++)
            arc.length = fmax(arc.length, up_to(x[i], x[j]));
        if (arc.length < best.length)
            best = arc;
    }
    return best;
}

static bool is_point(const double *x, uint32_t n, double start)
{
    for (uint32_t i = 0; i < n; i++)
        if (x[i] == start)
            return true;
    return false;
}

static const char *cause(const double *x, uint32_t n, struct arc right,
                         struct arc found)
{
    double low = 1, high = 0;
    for (uint32_t i = 0; i < n; i++) {
        low = fmin(low, x[i]);
        high = fmax(high, x[i]);
    }
    if (fabs(found.length - (high - low)) <= tolerance &&
        found.start == low && n > 1)
        return "This is the arc from the smallest to the largest. The "
               "border is not a wall: the widest gap may be elsewhere.";
    if (right.start == low &&
        fabs(right.length - (high - low)) <= tolerance)
        return "The widest gap is the one across the border, from the "
               "largest to the smallest: is it among those compared?";
    if (fabs(found.length - right.length) <= tolerance)
        return "The arc begins where the gap ends, at its upper end.";
    return "Are the points sorted before their gaps are taken? A "
           "comparison for qsort that returns x - y returns an int, "
           "which is 0 for all points of this circle.";
}

static void check(const double *x, uint32_t n)
{
    struct arc *found = kit_output("the answer", 1, sizeof *found);
    CALL(*found = STUDENT(shortest_arc)(x, n));
    struct arc right = search(x, n);
    const char *expected = kit_text("from %.17g on, length %.17g",
                                    right.start, right.length);
    const char *answer = kit_text("from %.17g on, length %.17g",
                                  found->start, found->length);
    if (!is_point(x, n, found->start))
        WRONG(.expected = expected, .found = answer,
              .cause = "The arc must begin at one of the points.");
    if (!(fabs(found->length - right.length) <= tolerance))
        WRONG(.expected = expected, .found = answer,
              .cause = cause(x, n, right, *found));
    for (uint32_t i = 0; i < n; i++)
        if (up_to(found->start, x[i]) > found->length + tolerance)
            WRONG(.where = kit_text("point %u at %.17g is not in the "
                                    "arc",
                                    i, x[i]),
                  .expected = expected, .found = answer,
                  .cause = cause(x, n, right, *found));
}

// n random points of an arc.
static double *points_of(struct arc arc, uint32_t n, uint64_t seed)
{
    struct random random = {seed};
    double *x = kit_input("x", n, sizeof *x);
    for (uint32_t i = 0; i < n; i++) {
        double place = arc.start + arc.length * random_uniform(&random);
        x[i] = place - floor(place);
    }
    kit_given("%u points between %g and %g", n, arc.start,
              arc.start + arc.length);
    return x;
}

static void one(uint64_t seed)
{
    check(points_of((struct arc){0, 1}, 1, seed), 1);
    kit_next_case();
    check(points_of((struct arc){0.75, 0}, 5, seed), 5);
}

static void two(uint64_t seed)
{
    double *x = kit_input("x", 2, sizeof *x);
    x[0] = 0.9;
    x[1] = 0.2;
    kit_given("2 points, at 0.9 and 0.2");
    check(x, 2);
    kit_next_case();
    check(points_of((struct arc){0.2, 0.3}, 2, seed), 2);
    kit_next_case();
    check(points_of((struct arc){0.3, 0.4}, 40, seed), 40);
}

static void across(uint64_t seed)
{
    check(points_of((struct arc){0.8, 0.4}, 40, seed), 40);
    kit_next_case();
    check(points_of((struct arc){0.99, 0.9}, 300, seed), 300);
}

static void around(uint64_t seed)
{
    for (uint32_t n = 3; n < 60; n++) {
        check(points_of((struct arc){0, 1}, n, seed + n), n);
        kit_next_case();
    }
}

// ---- many points ---------------------------------------------------

// All pairs take the time of fifty sorts and more, the solution that of
// one. A sort alone is too short to be timed.
enum { MANY = 10000, SORTS = 12, ROUNDS = 8 };

static const double *many_points;
static double *many_copies; // ROUNDS of them
static struct arc *many_found;

static const char all_pairs[] =
    "An arc from every point, held against every point, takes n times "
    "n steps. In order of place, only points that follow each other "
    "have a gap between them.";

static int by_value(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return *x < *y ? -1 : *x > *y;
}

static void sort_all(void)
{
    for (int round = 0; round < ROUNDS; round++) {
        double *copy = many_copies + (size_t)round * MANY;
        memcpy(copy, many_points, MANY * sizeof *copy);
        qsort(copy, MANY, sizeof *copy, by_value);
    }
}

static void sorts(void)
{
    CALL(sort_all());
}

static void find_all(void)
{
    for (int round = 0; round < ROUNDS; round++)
        *many_found = STUDENT(shortest_arc)(many_points, MANY);
}

static void arcs(void)
{
    CALL(find_all());
}

// The points of an arc, and its two ends among them.
static void check_many(struct arc arc, uint64_t seed)
{
    double *x = points_of(arc, MANY, seed);
    x[MANY / 3] = arc.start;
    x[MANY / 2] = arc.start + arc.length;
    x[MANY / 2] -= floor(x[MANY / 2]);
    many_points = x;
    many_found = kit_output("the answer", 1, sizeof *many_found);
    many_copies = kit_output("copies", (size_t)ROUNDS * MANY,
                             sizeof *many_copies);
    kit_if_endless(all_pairs);
    CALL(*many_found = STUDENT(shortest_arc)(x, MANY));
    if (many_found->start != arc.start ||
        !(fabs(many_found->length - arc.length) <= tolerance))
        WRONG(.expected = kit_text("from %.17g on, length %.17g",
                                   arc.start, arc.length),
              .found = kit_text("from %.17g on, length %.17g",
                                many_found->start, many_found->length),
              .cause = "With few points it was right: does anything "
                       "depend on how many there are?");
    if (kit_is_sanitized())
        return;
    double ratio = kit_race((struct kit_race){arcs, sorts, .cores = 1});
    kit_bands(ratio, (struct kit_band[]){{SORTS, 3}, {0, 0}},
              (struct kit_fault){
                  .expected = "at most 12 times the time of a sort",
                  .found = kit_text("%.0f times", ratio),
                  .cause = all_pairs});
}

static void many(uint64_t seed)
{
    check_many((struct arc){0.125, 0.75}, seed);
}

static void many_across(uint64_t seed)
{
    check_many((struct arc){0.75, 0.875}, seed);
}

const struct kit_test kit_tests[] = {
    {"one", 1, "a single point, or all in one place", one},
    {"two", 1, "two points, or some away from the border", two},
    {"across", 1, "points on both sides of the border", across},
    {"around", 1, "points all the way round", around},
    {"many", 3, "10,000 points, in the time of a few sorts", many},
    {"many-across", 3, "10,000 points across the border", many_across},
    {0},
};
