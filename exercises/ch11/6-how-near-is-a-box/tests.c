// Tests of the bound: that no place in the box is nearer, and that one
// is as near, among many places that stand for the box.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

// Several cases, which are put into one call.
static struct one_case {
    struct box box;
    double x, y, width, height;
} cases[300];
static double *found;

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

static double right(const struct one_case *c)
{
    const double apart_in[2] = {
        least(c->box.left, c->box.right, c->x, c->width),
        least(c->box.bottom, c->box.top, c->y, c->height)};
    return apart_in[0] * apart_in[0] + apart_in[1] * apart_in[1];
}

static struct one_case draw_case(struct random *random)
{
    double a = draw(random), b = draw(random);
    double c = draw(random), d = draw(random);
    return (struct one_case){
        .box = {fmin(a, b), fmax(a, b), fmin(c, d), fmax(c, d)},
        .x = draw(random),
        .y = draw(random)};
}

static const char *cause_of(double answer, double expected)
{
    if (answer < expected)
        return "This is too near: is a gap less than 0 taken for one, "
               "or the seam counted where there is none?";
    if (expected == 0)
        return "The place is in the box.";
    return "Some place in the box is nearer: think of each axis by "
           "itself, and of both ways around.";
}

static void check(const struct one_case *c, double answer)
{
    const double expected = right(c);
    if (answer != expected)
        WRONG(.where = kit_text("(%g, %g), box %g to %g by %g to %g",
                                c->x, c->y, c->box.left, c->box.right,
                                c->box.bottom, c->box.top),
              .expected = kit_text("%g", expected),
              .found = kit_text("%g", answer),
              .cause = cause_of(answer, expected));
}

static void plain(uint64_t seed)
{
    struct random random = {seed};
    kit_given("a place and a box");
    found = kit_output("the answer", 300, sizeof *found);
    for (int k = 0; k < 300; k++) {
        cases[k] = draw_case(&random);
        cases[k].width = cases[k].height = INFINITY;
    }
    CALL(for (int k = 0; k < 300; k++) {
        const struct one_case *c = &cases[k];
        found[k] = STUDENT(nearest2)(c->box, c->x, c->y);
        check(c, found[k]);
    });
    for (int k = 0; k < 300; k++)
        check(&cases[k], found[k]);
}

static void check_around(int count)
{
    found = kit_output("the answer", count, sizeof *found);
    CALL(for (int k = 0; k < count; k++) {
        const struct one_case *c = &cases[k];
        found[k] = STUDENT(nearest2_around)(c->box, c->x, c->y,
                                            c->width, c->height);
        check(c, found[k]);
    });
    for (int k = 0; k < count; k++)
        check(&cases[k], found[k]);
}

static void around(uint64_t seed)
{
    struct random random = {seed};
    kit_given("a place and a box in a period");
    for (int k = 0; k < 300; k++) {
        cases[k] = draw_case(&random);
        cases[k].width = 1, cases[k].height = k % 2 ? 1 : 1.25;
    }
    check_around(300);
}

// A box as small as a place.
static void place(uint64_t seed)
{
    struct random random = {seed};
    kit_given("a box that is a single place");
    for (int k = 0; k < 100; k++) {
        struct one_case *c = &cases[k];
        *c = draw_case(&random);
        c->box.right = c->box.left, c->box.top = c->box.bottom;
        c->width = c->height = 1;
    }
    check_around(100);
}

const struct kit_test kit_tests[] = {
    {"plain", 4, "in the plane", plain},
    {"around", 4, "where all repeats", around},
    {"place", 2, "a box that is a place", place},
    {0},
};
