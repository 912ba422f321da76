// Tests of the cut: what must hold of it, one after the other, and that
// no cut is nearer to the middle, among all that there are.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int ascending(const void *one, const void *other)
{
    double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

// All cuts of the sorted numbers, the best of them.
static uint32_t best_cut(const double *sorted, uint32_t n)
{
    uint32_t best = 0;
    for (uint32_t k = 1; k < n; k++)
        if (sorted[k] != sorted[k - 1] &&
            (best == 0 || llabs(2LL * k - n) < llabs(2LL * best - n)))
            best = k;
    return best;
}

static const char *cause_of(const double *sorted, uint32_t n,
                            uint32_t first)
{
    if (first == 0 || first >= n)
        return "One part is empty: where the median is the least "
               "number, cut above it.";
    if (sorted[first] == sorted[first - 1])
        return "Equal numbers are on both sides of the cut.";
    if (first + best_cut(sorted, n) == n)
        return "Two cuts are equally near to the middle: take the one "
               "with the smaller first part.";
    return "There is a cut nearer to the middle: below the median or "
           "right above it.";
}

static void try_numbers(const double *number, uint32_t n)
{
    double *value = kit_output("value", n, sizeof *value);
    uint32_t *first = kit_output("the answer", 1, sizeof *first);
    memcpy(value, number, n * sizeof *value);
    CALL(*first = STUDENT(cut_in_two)(value, n));
    double *sorted = malloc(n * sizeof *sorted);
    double *found = malloc(n * sizeof *found);
    memcpy(sorted, number, n * sizeof *sorted);
    memcpy(found, value, n * sizeof *found);
    qsort(sorted, n, sizeof *sorted, ascending);
    qsort(found, n, sizeof *found, ascending);
    if (memcmp(sorted, found, n * sizeof *found) != 0)
        WRONG(.expected = "the same numbers in another order",
              .found = "other numbers",
              .cause = "Only change places: no number may be lost.");
    const uint32_t right = best_cut(sorted, n);
    if (*first != right)
        WRONG(.expected =
                  kit_text("%u numbers in the first part", right),
              .found = kit_text("%u", *first),
              .cause = cause_of(sorted, n, *first));
    for (uint32_t k = 0; k < n; k++)
        if ((k < right) != (value[k] < sorted[right]))
            WRONG(.where = kit_text("place %u", k),
                  .expected = "all that is less in the first part",
                  .found = kit_text("%g", value[k]),
                  .cause = "The number of the first part is right, "
                           "but not what is in it: order the array, "
                           "too.");
    free(found);
    free(sorted);
    kit_next_case();
}

static void try_few_values(uint32_t n, uint32_t values, uint64_t seed)
{
    struct random random = {seed};
    double number[1000];
    for (uint32_t k = 0; k < n; k++)
        number[k] = (double)(random_bits(&random) % values);
    number[0] = 0;
    number[n - 1] = values;
    kit_given("%u numbers, of %u different values", n, values + 1);
    try_numbers(number, n);
}

static void different(uint64_t seed)
{
    struct random random = {seed};
    double number[101];
    for (uint32_t n = 2; n <= 101; n++) {
        for (uint32_t k = 0; k < n; k++)
            number[k] = random_uniform(&random);
        kit_given("%u different numbers", n);
        try_numbers(number, n);
    }
}

static void some_equal(uint64_t seed)
{
    for (uint32_t k = 0; k < 60; k++)
        try_few_values(2 + k, 1 + k % 7, seed + k);
    try_few_values(1000, 5, seed);
}

// The share of equal ones at the left end, at the right, in between.
static void try_heavy(uint32_t before, uint32_t heavy, uint32_t after)
{
    double number[100];
    uint32_t n = 0;
    for (uint32_t k = 0; k < heavy; k++)
        number[n++] = 5;
    for (uint32_t k = 0; k < after; k++)
        number[n++] = 6 + k;
    for (uint32_t k = 0; k < before; k++)
        number[n++] = 4 - (double)k;
    kit_given("%u numbers, %u of them equal, %u less, %u more", n,
              heavy, before, after);
    try_numbers(number, n);
}

static void heavy(uint64_t seed)
{
    (void)seed;
    try_heavy(0, 7, 5);
    try_heavy(5, 7, 0);
    try_heavy(3, 7, 2);
    try_heavy(2, 7, 3);
    try_heavy(2, 7, 2);
    try_heavy(1, 98, 1);
    try_heavy(0, 1, 1);
    try_heavy(0, 99, 1);
    try_heavy(1, 99, 0);
}

// So many that no n squared ends in time, and a tenth of them equal, on
// both sides of the middle.
static void many(uint64_t seed)
{
    const uint32_t n = 1000000;
    struct random random = {seed};
    double *number = malloc(n * sizeof *number);
    for (uint32_t k = 0; k < n; k++) {
        const double x = random_uniform(&random);
        number[k] = x > 0.47 && x < 0.57 ? 0.5 : x;
    }
    kit_given("a million numbers, a tenth of them equal");
    kit_if_endless("Sorting in n log n takes a second at most. Does it "
                   "become n squared, perhaps among equal numbers?");
    try_numbers(number, n);
    free(number);
}

const struct kit_test kit_tests[] = {
    {"different", 4, "different numbers are cut in the middle",
     different},
    {"some-equal", 2, "equal numbers stay together", some_equal},
    {"heavy", 2, "most numbers are equal", heavy},
    {"many", 2, "a million numbers", many},
    {0},
};
