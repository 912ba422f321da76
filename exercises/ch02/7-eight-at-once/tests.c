// Tests of the nearest distances to another set: answers, against a
// sort of all distances of a query, and time, against a loop with the
// same arithmetic that finds nothing.
#include "common/geometry.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>
#include <string.h>

static double between(struct points from, uint32_t i, struct points to,
                      uint32_t j)
{
    return distance2(to.x[j] - from.x[i], to.y[j] - from.y[i]);
}

static int by_value(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

// All distances of a query, the smallest first.
static void sort_distances(struct points from, uint32_t i,
                           struct points to, double *sorted)
{
    for (uint32_t j = 0; j < to.n; j++)
        sorted[j] = between(from, i, to, j);
    qsort(sorted, to.n, sizeof *sorted, by_value);
}

static const char *cause(struct points from, uint32_t i,
                         struct points to, const double *sorted,
                         double found)
{
    double least = sorted[0], unset;
    memset(&unset, 0xa5, sizeof unset); // what a new output holds
    if (found == unset)
        return "This element was never set. Does the number of queries "
               "have to be a multiple of the lanes?";
    if (found < least)
        return "No point is that near. Does each lane begin with a "
               "distance that is larger than all others?";
    if (found == sqrt(least))
        return "The square of the distance is wanted, not its root.";
    if (found > sorted[to.n - 1])
        return "No distance is that large: a lane has kept what it "
               "began with.";
    for (uint32_t j = 0; j < to.n; j++)
        if (sorted[j] == found)
            return least == between(from, i, to, to.n - 1)
                       ? "The nearest is the last point of the other "
                         "set: is it looked at?"
                       : "This is the distance to another point. Has "
                         "each lane seen all candidates, and have all "
                         "lanes been compared in the end?";
    return "This is no distance of this query: do lanes and queries "
           "belong together?";
}

static void check(struct points from, struct points to)
{
    double *found = kit_output("nearest2", from.n, sizeof *found);
    double *sorted = kit_input("sorted", to.n, sizeof *sorted);
    kit_given("%u queries, %u candidates", from.n, to.n);
    CALL(STUDENT(nearest_in)(from, to, found));
    for (uint32_t i = 0; i < from.n; i++) {
        sort_distances(from, i, to, sorted);
        if (found[i] != sorted[0])
            WRONG(.where = kit_point(from, i),
                  .expected = kit_text("%.17g", sorted[0]),
                  .found = kit_text("%.17g", found[i]),
                  .cause = cause(from, i, to, sorted, found[i]));
    }
    kit_next_case();
}

static void right(uint64_t seed)
{
    check(kit_points("uniform", 400, seed),
          kit_points("uniform", 300, seed + 1));
    check(kit_points("clustered", 160, seed),
          kit_points("circle", 333, seed));
}

// All numbers of queries around a few lanes.
static void odd_numbers(uint64_t seed)
{
    for (uint32_t n = 0; n <= 34; n++)
        check(kit_points("uniform", n, seed),
              kit_points("uniform", 1 + n % 19, seed + 1));
}

static void far_apart(uint64_t seed)
{
    for (int large = 0; large <= 1; large++) {
        struct points from = kit_points("uniform", 19, seed);
        struct points to = kit_points("uniform", 23, seed + 1);
        for (uint32_t j = 0; j < to.n; j++)
            to.x[j] = large ? 1e152 * to.x[j] : to.x[j] + 1e9;
        check(from, to);
    }
}

// ---- time ----------------------------------------------------------

enum { QUERIES = 4000, CANDIDATES = 12000 };
static struct points from, to;
static double *found2;
static uint64_t *closer;

// The arithmetic of all pairs, and a comparison that the compiler can
// make in lanes by itself.
static void count_closer(void)
{
    for (uint32_t i = 0; i < from.n; i++) {
        const double x = from.x[i], y = from.y[i], limit2 = 1e-4;
        const double *cx = to.x, *cy = to.y;
        uint64_t count = 0;
        for (uint32_t j = 0; j < CANDIDATES; j++)
            count += distance2(cx[j] - x, cy[j] - y) < limit2;
        closer[i] = count;
    }
}

static void ours(void)
{
    CALL(count_closer());
}

static void theirs(void)
{
    CALL(STUDENT(nearest_in)(from, to, found2));
}

static void in_time(uint64_t seed)
{
    check(kit_points("uniform", 100, seed),
          kit_points("uniform", 300, seed + 1));
    from = kit_points("uniform", QUERIES, seed);
    to = kit_points("uniform", CANDIDATES, seed + 1);
    kit_given("%u queries, %u candidates", from.n, to.n);
    found2 = kit_output("nearest2", from.n, sizeof *found2);
    closer = kit_output("counts", from.n, sizeof *closer);
    double ratio =
        kit_race((struct kit_race){theirs, ours, .cores = 1});
    kit_bands(ratio,
              (struct kit_band[]){{1.4, 6}, {1.8, 4}, {2.3, 2}, {0, 0}},
              (struct kit_fault){
                  .expected = "at most 1.4 times the time of "
                              "a loop that counts close pairs",
                  .found = kit_text("%.1f times", ratio),
                  .cause = "A single best is a chain: each comparison "
                           "waits for the one before, and there is one "
                           "lane at work. Which bests have nothing to "
                           "do with each other? If there are eight "
                           "bests already: does #pragma omp simd "
                           "stand before the loop over the lanes, "
                           "and is the minimum written with ?: and "
                           "without a function?"});
}

const struct kit_test kit_tests[] = {
    {"right", 2, "distances to another set", right},
    {"odd-numbers", 1, "any number of queries", odd_numbers},
    {"far-apart", 1, "large distances", far_apart},
    {"time", 6, "48 million pairs, in lanes", in_time},
    {0},
};
