// Tests of the enemy: the numbers are what was asked for, and the cuts
// in the middle go deep, while medians would not.
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>

static int ascending(const void *one, const void *other)
{
    double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

// Of sorted numbers, begin .. end - 1.
static uint32_t depth_of(const double *x, uint32_t begin, uint32_t end)
{
    uint32_t depth = 0;
    while (end - begin > 1) {
        double middle = x[begin] + (x[end - 1] - x[begin]) / 2;
        uint32_t at = begin;
        while (at < end && x[at] < middle)
            at++;
        if (at == begin || at == end)
            return depth + 1; // neighbors in double: no middle
        uint32_t left = at - begin, right = end - at;
        depth++;
        if (left == 1)
            begin = at;
        else if (right == 1)
            end = at;
        else {
            uint32_t a = depth_of(x, begin, at);
            uint32_t b = depth_of(x, at, end);
            return depth + (a > b ? a : b);
        }
    }
    return depth;
}

static uint32_t try_depth(uint32_t n)
{
    kit_next_case();
    double *x = kit_output("x", n, sizeof *x);
    kit_given("%u numbers", n);
    CALL(STUDENT(go_deep)(x, n));
    double *sorted = malloc(n * sizeof *sorted);
    for (uint32_t k = 0; k < n; k++)
        sorted[k] = x[k];
    qsort(sorted, n, sizeof *sorted, ascending);
    for (uint32_t k = 0; k < n; k++) {
        if (!(sorted[k] >= 0 && sorted[k] <= 1))
            WRONG(.expected = "numbers from 0 to 1",
                  .found = kit_text("%g", sorted[k]),
                  .cause = "All numbers are set, and lie in the "
                           "interval.");
        if (k > 0 && sorted[k] == sorted[k - 1])
            WRONG(.expected = "different numbers",
                  .found = kit_text("%g twice", sorted[k]),
                  .cause = "Two are the same: do the powers vanish, "
                           "or is one of them 0 twice?");
    }
    uint32_t depth = depth_of(sorted, 0, n);
    free(sorted);
    return depth;
}

static void reach(uint32_t n, uint32_t least)
{
    uint32_t depth = try_depth(n);
    if (depth < least)
        WRONG(.expected = kit_text("a depth of at least %u", least),
              .found = kit_text("%u", depth),
              .cause = "Of what should a cut take off as little as "
                       "possible? Let each leave all but one.");
}

static void few(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 2; n <= 20; n++)
        reach(n, n - 1);
}

static void hundred(uint64_t seed)
{
    (void)seed;
    reach(50, 49);
    reach(100, 99);
}

static void thousand(uint64_t seed)
{
    (void)seed;
    reach(1000, 999);
}

const struct kit_test kit_tests[] = {
    {"few", 3, "up to 20 numbers", few},
    {"hundred", 4, "50 and 100 numbers", hundred},
    {"thousand", 3, "1,000 numbers", thousand},
    {0},
};
