// Tests of the smallest slice: the slice itself, against a walk over
// all places, and how many numbers were looked at.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

enum { MOST_AXES = 5 };

static uint32_t n;
static int d;
static double *sorted[MOST_AXES], *low, *high;
static uint64_t *looks;
static struct axis_slice *found;

double number_at(int axis, uint32_t place)
{
    ++*looks;
    return sorted[axis][place];
}

// Numbers are multiples of 1/steps, so that many are equal.
static void prepare(uint32_t count, int axes, double steps,
                    uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    n = count;
    d = axes;
    low = kit_input("low", d, sizeof *low);
    high = kit_input("high", d, sizeof *high);
    looks = kit_output("the count", 1, sizeof *looks);
    found = kit_output("the answer", 1, sizeof *found);
    for (int axis = 0; axis < d; axis++) {
        sorted[axis] = kit_input("the numbers", n, sizeof(double));
        double sum = 0;
        for (uint32_t k = 0; k < n; k++) {
            sum += floor(3 * random_uniform(&random)) / 2;
            sorted[axis][k] = floor(sum) / steps;
        }
        const double a = sorted[axis][random_bits(&random) % n];
        const double b = sorted[axis][random_bits(&random) % n];
        const double off = random_bits(&random) % 3 ? 0 : 0.25 / steps;
        low[axis] = fmin(a, b) + off;
        high[axis] = fmax(a, b) + off;
    }
    kit_given("%u points in %d dimensions", n, d);
}

// The places of one coordinate, found by looking at every number.
static struct axis_slice slice_of(int axis, bool half_open)
{
    struct axis_slice slice = {.axis = axis};
    for (const double *x = sorted[axis]; x < sorted[axis] + n; x++) {
        slice.begin += *x < low[axis];
        slice.end += half_open ? *x < high[axis] : *x <= high[axis];
    }
    return slice;
}

static struct axis_slice walk(bool half_open, bool last)
{
    struct axis_slice best = slice_of(0, half_open);
    for (int axis = 1; axis < d; axis++) {
        const struct axis_slice other = slice_of(axis, half_open);
        const uint32_t least = best.end - best.begin + last;
        if (other.end - other.begin < least)
            best = other;
    }
    return best;
}

static bool same(struct axis_slice a, struct axis_slice b)
{
    return a.axis == b.axis && a.begin == b.begin && a.end == b.end;
}

static const char *text_of(struct axis_slice s)
{
    if (s.begin >= s.end)
        return kit_text("coordinate %d, begin %u, end %u: no place",
                        s.axis, s.begin, s.end);
    return kit_text("coordinate %d, begin %u, end %u: %u places",
                    s.axis, s.begin, s.end, s.end - s.begin);
}

static void ask(void)
{
    *looks = 0;
    CALL(*looks = 0; *found = STUDENT(smallest_slice)(n, d, low, high));
    const struct axis_slice right = walk(false, false);
    if (same(*found, right))
        return;
    const char *cause = "Both ends are the first place that is not in "
                        "a stretch of lower numbers.";
    if (same(*found, walk(true, false)))
        cause = "A number equal to the upper border is in the box.";
    else if (same(*found, walk(false, true)))
        cause = "Of equally short slices take the lowest coordinate.";
    else if (found->axis != right.axis)
        cause = "Another coordinate has fewer.";
    else if (found->begin > right.begin)
        cause = "A number equal to the lower border is in the box.";
    WRONG(.expected = text_of(right), .found = text_of(*found),
          .cause = cause);
}

static void right(uint64_t seed)
{
    for (int trial = 0; trial < 60; trial++) {
        prepare(1 + trial * trial / 4, 1 + trial % MOST_AXES, 4,
                seed + trial);
        ask();
    }
}

static void ties(uint64_t seed)
{
    for (int trial = 0; trial < 40; trial++) {
        prepare(12, MOST_AXES, 1, seed + trial);
        ask();
    }
}

static void count(uint64_t seed)
{
    double worst = 0, most = 0;
    for (int trial = 0; trial < 20; trial++) {
        prepare(20000, 3, 16, seed + trial);
        ask();
        most = 2 * d * (floor(log2(n)) + 2);
        worst = fmax(worst, *looks / most);
    }
    kit_bands(
        worst, (struct kit_band[]){{1, 6}, {4, 3}, {0, 0}},
        (struct kit_fault){
            .expected = kit_text("at most 2 d (log2 n + 2) = %.0f "
                                 "numbers looked at",
                                 most),
            .found = kit_text("%.0f numbers looked at, %.1f "
                              "times as many",
                              worst * most, worst),
            .cause = "Search by halves: each look halves what is "
                     "left."});
}

const struct kit_test kit_tests[] = {
    {"right", 2, "the slice with the fewest, borders included", right},
    {"ties", 2, "numbers and slices that are equal", ties},
    {"count", 6, "few numbers looked at", count},
    {0},
};
