// Tests of the bound: that no place in the box is nearer, and that one
// is as near, among many places that stand for the box.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

static struct box box;
static double x, y, width, height, *found;

// All coordinates are multiples of 1/64, so that every result is exact.
static double draw(struct random *random)
{
    return (double)(random_bits(random) % 65) / 64;
}

static double apart(double a, double b, double period)
{
    double d = fabs(a - b);
    return fmin(d, period - d);
}

// The least along one axis, over all multiples of 1/64 in the interval.
static double least(double low, double high, double at, double period)
{
    double best = INFINITY;
    for (double p = low; p <= high; p += 1.0 / 64)
        best = fmin(best, apart(p, at, period));
    return best;
}

static double right(void)
{
    const double apart_in[2] = {least(box.left, box.right, x, width),
                                least(box.bottom, box.top, y, height)};
    return apart_in[0] * apart_in[0] + apart_in[1] * apart_in[1];
}

static void take(struct random *random)
{
    double a = draw(random), b = draw(random);
    double c = draw(random), d = draw(random);
    kit_next_case();
    found = kit_output("the answer", 1, sizeof *found);
    box = (struct box){fmin(a, b), fmax(a, b), fmin(c, d), fmax(c, d)};
    x = draw(random);
    y = draw(random);
}

static const char *cause_of(double expected)
{
    if (*found < expected)
        return "This is too near: is a gap less than 0 taken for one, "
               "or the seam counted where there is none?";
    if (expected == 0)
        return "The place is in the box.";
    return "Some place in the box is nearer: think of each axis by "
           "itself, and of both ways around.";
}

static void check(void)
{
    const double expected = right();
    if (*found != expected)
        WRONG(.where =
                  kit_text("(%g, %g), box %g to %g by %g to %g", x, y,
                           box.left, box.right, box.bottom, box.top),
              .expected = kit_text("%g", expected),
              .found = kit_text("%g", *found),
              .cause = cause_of(expected));
}

static void plain(uint64_t seed)
{
    struct random random = {seed};
    width = height = INFINITY;
    kit_given("a place and a box");
    for (int k = 0; k < 300; k++) {
        take(&random);
        CALL(*found = STUDENT(nearest2)(box, x, y));
        check();
    }
}

static void around(uint64_t seed)
{
    struct random random = {seed};
    kit_given("a place and a box in a period");
    for (int k = 0; k < 300; k++) {
        take(&random);
        width = 1, height = k % 2 ? 1 : 1.25;
        CALL(*found =
                 STUDENT(nearest2_around)(box, x, y, width, height));
        check();
    }
}

// A box as small as a place.
static void place(uint64_t seed)
{
    struct random random = {seed};
    kit_given("a box that is a single place");
    for (int k = 0; k < 100; k++) {
        take(&random);
        box.right = box.left, box.top = box.bottom;
        width = height = 1;
        CALL(*found =
                 STUDENT(nearest2_around)(box, x, y, width, height));
        check();
    }
}

const struct kit_test kit_tests[] = {
    {"plain", 4, "in the plane", plain},
    {"around", 4, "where all repeats", around},
    {"place", 2, "a box that is a place", place},
    {0},
};
