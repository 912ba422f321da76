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

static double middle_of(const double *x, uint32_t begin, uint32_t end)
{
    return x[begin] + (x[end - 1] - x[begin]) / 2;
}

// Of sorted numbers, begin .. end - 1, how many go to the left.
static uint32_t left_of(const double *x, uint32_t begin, uint32_t end)
{
    double middle = middle_of(x, begin, end);
    uint32_t at = begin;
    while (at < end && x[at] < middle)
        at++;
    return at - begin;
}

// Cuts as long as one side is a single number. Returns how many cuts
// these were; what is left is begin .. end - 1.
static uint32_t cut_singles(const double *x, uint32_t *begin,
                            uint32_t *end)
{
    for (uint32_t cuts = 0;; cuts++) {
        uint32_t left = left_of(x, *begin, *end);
        uint32_t right = *end - *begin - left;
        if (left == 1 && right > 0)
            ++*begin;
        else if (right == 1 && left > 0)
            --*end;
        else
            return cuts;
    }
}

static uint32_t depth_of(const double *x, uint32_t begin, uint32_t end)
{
    uint32_t depth = cut_singles(x, &begin, &end);
    if (end - begin == 1)
        return depth;
    uint32_t left = left_of(x, begin, end);
    if (left == 0 || left == end - begin)
        return depth + 1; // neighbors in double: no middle
    uint32_t a = depth_of(x, begin, begin + left);
    uint32_t b = depth_of(x, begin + left, end);
    return depth + 1 + (a > b ? a : b);
}

// Is the middle of two numbers from 0 to 1 rounded down? What their
// sum has lost is exact.
static bool is_rounded_down(double least, double greatest,
                            double middle)
{
    double sum = least + greatest;
    double lost = least - (sum - greatest);
    return 2 * middle < sum || (2 * middle == sum && lost > 0);
}

// Where the first depth was lost, of n sorted numbers.
struct loss {
    uint32_t depth, off; // the cut's depth, how many it took off
    double middle;
    bool rounded; // to a number that would be less otherwise
};

static struct loss first_loss(const double *x, uint32_t n)
{
    uint32_t begin = 0, end = n;
    uint32_t depth = cut_singles(x, &begin, &end) + 1;
    uint32_t left = left_of(x, begin, end), right = end - begin - left;
    double middle = middle_of(x, begin, end);
    return (struct loss){
        depth, left < right ? left : right, middle,
        right > 0 && x[begin + left] == middle &&
            is_rounded_down(x[begin], x[end - 1], middle)};
}

// Calls, and returns the numbers in ascending order.
static double *numbers(uint32_t n)
{
    kit_next_case();
    double *x = kit_output("x", n, sizeof *x);
    kit_given("%u numbers", n);
    CALL(STUDENT(go_deep)(x, n));
    double *sorted = kit_input("sorted", n, sizeof *sorted);
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
    return sorted;
}

static void reach(uint32_t n, uint32_t least)
{
    double *x = numbers(n);
    uint32_t depth = depth_of(x, 0, n);
    if (depth >= least)
        return;
    struct loss loss = first_loss(x, n);
    WRONG(.expected = kit_text("a depth of at least %u", least),
          .found = kit_text("%u: at depth %u the cut at %.3g took off "
                            "%u",
                            depth, loss.depth, loss.middle, loss.off),
          .cause = loss.rounded
                       ? "This middle was rounded, down to one of your "
                         "numbers, which is not less than itself."
                       : "Of what should a cut take off as little as "
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
