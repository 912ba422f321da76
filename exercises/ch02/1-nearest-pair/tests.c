// Tests of the nearest pair: answers only, against a list of all pairs
// that is sorted by distance and indices.
#include "common/geometry.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>

static double between(struct points points, uint32_t i, uint32_t j)
{
    return distance2(points.x[j] - points.x[i],
                     points.y[j] - points.y[i]);
}

static int by_distance(const void *a, const void *b)
{
    const struct pair *p = a, *q = b;
    if (p->distance2 != q->distance2)
        return p->distance2 < q->distance2 ? -1 : 1;
    if (p->i != q->i)
        return p->i < q->i ? -1 : 1;
    return (p->j > q->j) - (p->j < q->j);
}

// All pairs, numbered as in a full square, of which half is left out.
static struct pair *sort_pairs(struct points points)
{
    uint64_t n = points.n, count = 0;
    struct pair *pairs =
        kit_input("all pairs", n * (n - 1) / 2, sizeof *pairs);
    for (uint64_t k = 0; k < n * n; k++) {
        struct pair pair = {k % n, k / n, 0};
        if (pair.i >= pair.j)
            continue;
        pair.distance2 = between(points, pair.i, pair.j);
        pairs[count++] = pair;
    }
    qsort(pairs, count, sizeof *pairs, by_distance);
    return pairs;
}

static const char *tell(struct points points, struct pair pair)
{
    return kit_text("%s and %s, squared distance %.17g",
                    kit_point(points, pair.i),
                    kit_point(points, pair.j), pair.distance2);
}

static const char *cause(struct points points, const struct pair *pairs,
                         struct pair found)
{
    struct pair right = pairs[0];
    uint64_t count = (uint64_t)points.n * (points.n - 1) / 2;
    const char *unbeaten =
        "No pair beat what the search began with: begin with the first "
        "pair and its distance.";
    if (isinf(right.distance2) && found.i == found.j)
        return "The squared distances are infinite, so none beats the "
               "infinity that the search began with: begin with a pair "
               "and its distance.";
    if (found.i == found.j && found.distance2 != 0)
        return unbeaten;
    if (found.i == found.j)
        return "The pair joins a point with itself, but a point is not "
               "its own neighbor: where does the inner loop begin?";
    if (found.i >= points.n || found.j >= points.n)
        return "An index was never set. Does the search begin with a "
               "distance that every pair beats?";
    if (found.i > found.j)
        return "Of the two indices, the lower comes first.";
    double really = between(points, found.i, found.j);
    if (found.distance2 != really) {
        if (found.distance2 == sqrt(really))
            return "The square of the distance is asked for, not its "
                   "root.";
        if (points.n > 2 && found.i == 0 && found.j == 1 &&
            found.distance2 <= right.distance2)
            return unbeaten;
        return "The distance is not that of this pair: are indices and "
               "distance always kept together?";
    }
    if (really == right.distance2)
        return "These pairs tie. A comparison with <= keeps the last "
               "of them; or the loops run in another order.";
    if (found.distance2 == pairs[count - 1].distance2)
        return "This is the furthest pair: is the comparison the wrong "
               "way round?";
    if (right.j == points.n - 1)
        return "Is the last point ever looked at?";
    return "This pair was missed: does the inner loop run over all j "
           "after i, and is the best pair replaced by every better "
           "one?";
}

static void check(struct points points)
{
    struct pair *found = kit_output("the answer", 1, sizeof *found);
    CALL(*found = STUDENT(nearest_pair)(points));
    const struct pair *pairs = sort_pairs(points);
    struct pair right = pairs[0];
    if (found->i != right.i || found->j != right.j ||
        found->distance2 != right.distance2)
        WRONG(.expected = tell(points, right),
              .found = tell(points, *found),
              .cause = cause(points, pairs, *found),
              .picture = {
                  points, {found->i, found->j}, {right.i, right.j}});
}

static void two_points(uint64_t seed)
{
    check(kit_points("uniform", 2, seed));
}

static void every_pair(uint64_t seed)
{
    const uint32_t n = 7;
    for (uint32_t k = 0; k < n * n; k++) {
        const uint32_t i = k / n, j = k % n;
        if (i >= j)
            continue;
        struct points points = kit_points("circle", n, seed);
        points.x[j] = points.x[i] + 1e-6;
        points.y[j] = points.y[i];
        kit_given("%u points, %u and %u side by side", n, i, j);
        check(points);
        kit_next_case();
    }
}

static void far_apart(uint64_t seed)
{
    struct points points = kit_points("uniform", 20, seed);
    for (uint32_t i = 0; i < points.n; i++)
        points.x[i] += 1e6 * i;
    kit_given("20 points, a million apart");
    check(points);
    kit_next_case();
    points = kit_points("uniform", 20, seed);
    for (uint32_t i = 0; i < points.n; i++)
        points.x[i] += 1e300 * i;
    kit_given("20 points, so far apart that the square is infinite");
    check(points);
}

static void ties(uint64_t seed)
{
    check(kit_points("lattice", 49, seed));
}

static void same_place(uint64_t seed)
{
    struct points points = kit_points("uniform", 60, seed);
    points.x[41] = points.x[13];
    points.y[41] = points.y[13];
    kit_given("60 points, 13 and 41 in the same place");
    check(points);
}

static void many(uint64_t seed)
{
    const char *distributions[] = {"uniform", "clustered", "circle"};
    for (int d = 0; d < 3; d++) {
        check(kit_points(distributions[d], 800, seed));
        kit_next_case();
    }
}

const struct kit_test kit_tests[] = {
    {"two-points", 1, "two points are a pair", two_points},
    {"every-pair", 3, "every pair is looked at", every_pair},
    {"far-apart", 1, "large distances", far_apart},
    {"ties", 2, "where pairs tie, the lowest indices", ties},
    {"same-place", 1, "two points in the same place", same_place},
    {"many", 2, "800 points, three distributions", many},
    {0},
};
