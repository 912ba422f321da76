// Tests of the shortest arc: it must begin at a point, hold all points
// and be no longer than the circle without its widest gap.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

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
}

static void equal(uint64_t seed)
{
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
}

static void inside(uint64_t seed)
{
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

const struct kit_test kit_tests[] = {
    {"one", 1, "a single point", one},
    {"equal", 1, "all in the same place", equal},
    {"two", 1, "two points", two},
    {"inside", 2, "points away from the border", inside},
    {"across", 3, "points on both sides of the border", across},
    {"around", 2, "points all the way round", around},
    {0},
};
