// Tests of the k nearest: answers, against a sort of all points by
// distance and index, and time, against the plain insertion.
#include "common/geometry.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>

struct neighbor {
    double distance2;
    uint32_t index;
};

static int by_distance(const void *a, const void *b)
{
    const struct neighbor *p = a, *q = b;
    if (p->distance2 != q->distance2)
        return p->distance2 < q->distance2 ? -1 : 1;
    return (p->index > q->index) - (p->index < q->index);
}

// All others, the nearest first; room for all n.
static void sort_all(struct points points, uint32_t i,
                     struct neighbor *sorted)
{
    uint32_t count = 0;
    for (uint32_t j = 0; j < points.n; j++)
        if (j != i)
            sorted[count++] =
                (struct neighbor){distance2(points.x[j] - points.x[i],
                                            points.y[j] - points.y[i]),
                                  j};
    qsort(sorted, count, sizeof *sorted, by_distance);
}

static const char *cause(struct points points, uint32_t i, uint32_t k,
                         uint32_t place, const uint32_t *neighbors,
                         const double *distances2,
                         struct neighbor right)
{
    uint32_t found = neighbors[place];
    for (uint32_t p = 0; p < k; p++)
        if (neighbors[p] == i)
            return "A point is not its own neighbor.";
    if (found >= points.n)
        return "This element was never set. While fewer than k are "
               "kept, "
               "is a point let in whatever its distance is?";
    double really = distance2(points.x[found] - points.x[i],
                              points.y[found] - points.y[i]);
    double claimed = distances2[place];
    if (claimed == sqrt(really) && really != 0)
        return "The square of the distance is asked for, not its root.";
    if (claimed != really)
        return "Index and distance do not belong together: when a "
               "neighbor moves back, move both.";
    if (really == right.distance2)
        return "These tie, and of several points at one distance the "
               "lower index comes first: >= in place of > turns "
               "them round.";
    for (uint32_t p = 0; p < k; p++)
        if (neighbors[p] == right.index)
            return "It is among those found, but they are not in "
                   "order of distance.";
    return "It was left out: does a better point still get in after "
           "the first k, and is the worst the one that leaves?";
}

static void check(struct points points, uint32_t i, uint32_t k)
{
    uint32_t *neighbors = kit_output("neighbors", k, sizeof *neighbors);
    double *distances2 =
        kit_output("distances2", k, sizeof *distances2);
    CALL(STUDENT(k_nearest)(points, i, k, neighbors, distances2));
    struct neighbor *sorted =
        kit_input("sorted", points.n, sizeof *sorted);
    sort_all(points, i, sorted);
    for (uint32_t p = 0; p < k; p++)
        if (neighbors[p] != sorted[p].index ||
            distances2[p] != sorted[p].distance2)
            WRONG(.where = kit_text("%s, k = %u, its neighbor %u",
                                    kit_point(points, i), k, p),
                  .expected =
                      kit_text("%s, squared distance %.17g",
                               kit_point(points, sorted[p].index),
                               sorted[p].distance2),
                  .found = kit_text("%s, squared distance %.17g",
                                    kit_point(points, neighbors[p]),
                                    distances2[p]),
                  .cause = cause(points, i, k, p, neighbors, distances2,
                                 sorted[p]),
                  .picture = {
                      points, {i, neighbors[p]}, {i, sorted[p].index}});
}

// Calls it for some points of a set, the first and the last among them.
static void check_some(const char *distribution, uint32_t n, uint32_t k,
                       uint64_t seed)
{
    for (uint32_t p = 0; p < 4; p++) {
        struct points points = kit_points(distribution, n, seed);
        check(points, (uint32_t)((uint64_t)(n - 1) * p / 3), k);
        kit_next_case();
    }
}

static void one(uint64_t seed)
{
    check_some("uniform", 2, 1, seed);
    check_some("uniform", 500, 1, seed);
}

static void all(uint64_t seed)
{
    check_some("uniform", 3, 2, seed);
    check_some("uniform", 60, 59, seed);
}

static void in_one_pass(uint64_t seed);

static void several(uint64_t seed)
{
    in_one_pass(seed);
    check_some("uniform", 1000, 10, seed);
    check_some("clustered", 1000, 37, seed);
}

static void ties(uint64_t seed)
{
    check_some("lattice", 81, 1, seed);
    check_some("lattice", 81, 6, seed);
    check_some("equal", 20, 5, seed);
}

// The nearest come last, or first: each is an insertion at the front,
// or none is.
static void in_order(uint64_t seed)
{
    in_one_pass(seed);
    for (int falling = 0; falling < 2; falling++) {
        struct points points = kit_points("uniform", 50, seed);
        for (uint32_t j = 0; j < points.n; j++) {
            points.x[j] = falling ? points.n - j : j;
            points.y[j] = 0;
        }
        kit_given("50 points on a line, the nearest %s",
                  falling ? "last" : "first");
        check(points, falling ? 49 : 0, 8);
        kit_next_case();
    }
}

// Far apart, but every square is finite: no number is large enough to
// begin with, except infinity.
static void large(uint64_t seed)
{
    static const double scales[] = {3, 1e6, 1e150};
    for (int s = 0; s < 3; s++) {
        struct points points = kit_points("uniform", 40, seed);
        for (uint32_t j = 0; j < points.n; j++) {
            points.x[j] = (j - 20.0) * scales[s];
            points.y[j] = points.y[j] * scales[s];
        }
        kit_given("40 points, neighbors about %g apart", scales[s]);
        check(points, 20, 39);
        kit_next_case();
    }
}

// ---- time ----------------------------------------------------------

enum { MANY = 200000, KEPT = 8, ASKED = 100 };
enum { HAND = 50, PASSES = 20 }; // one pass keeps so many
static struct points many;
static uint32_t *neighbors;
static double *distances2;
static uint32_t queries, keep;    // how many are asked for
static volatile uint32_t nearest; // keeps the passes

// One pass over all points, for the nearest only.
static uint32_t search(struct points points, uint32_t i)
{
    uint32_t found = i;
    double found2 = INFINITY;
    for (uint32_t j = 0; j < points.n; j++) {
        const double dx = points.x[j] - points.x[i];
        const double dy = points.y[j] - points.y[i];
        const double d2 = distance2(dx, dy);
        if (d2 < found2 && j != i) {
            found = j;
            found2 = d2;
        }
    }
    return found;
}

static void ours(void)
{
    CALL(for (uint32_t i = 0; i < queries; i++) nearest =
             search(many, i));
}

static void theirs(void)
{
    CALL(for (uint32_t i = 0; i < queries; i++)
             STUDENT(k_nearest)(many, i, keep, neighbors, distances2));
}

static void prepare_many(uint32_t k, uint64_t seed)
{
    many = kit_points("uniform", MANY, seed);
    keep = k;
    neighbors = kit_output("neighbors", k, sizeof *neighbors);
    distances2 = kit_output("distances2", k, sizeof *distances2);
    kit_given("%d points, uniform, k = %u", MANY, k);
    kit_if_endless("Is everything kept and sorted, or gone through "
                   "again for each neighbor? There is room for k, and "
                   "one pass is enough.");
}

// A hand of k cards goes through the points once; a sort of all of them
// takes many times as long, and so does a pass for each card.
static void in_one_pass(uint64_t seed)
{
    prepare_many(HAND, seed);
    queries = 8;
    ours();
    double pass = kit_seconds(false);
    theirs();
    double passes = kit_seconds(false) / pass;
    if (passes > PASSES && !kit_is_sanitized())
        WRONG(.expected =
                  "a time like that of one pass over all points",
              .found = kit_text("that of %.0f passes", passes),
              .cause = "Is everything kept and sorted, or gone through "
                       "again for each neighbor? There is room for k, "
                       "and one pass is enough.");
    kit_next_case();
}

static void in_time(uint64_t seed)
{
    in_one_pass(seed);
    check_some("uniform", 1000, KEPT, seed);
    prepare_many(KEPT, seed);
    queries = kit_is_sanitized() ? 8 : ASKED;
    double ratio =
        kit_race((struct kit_race){theirs, ours, .cores = 1});
    kit_bands(ratio,
              (struct kit_band[]){{2, 3}, {3, 2}, {4, 1}, {0, 0}},
              (struct kit_fault){
                  .expected = "at most twice the time of a search for "
                              "the nearest alone",
                  .found = kit_text("%.1f times", ratio),
                  .cause = "Most points are further than the last one "
                           "kept: a single comparison should rule "
                           "them out. Are all distances kept, sorted "
                           "or gone through again for each neighbor?"});
}

const struct kit_test kit_tests[] = {
    {"one", 1, "the nearest", one},
    {"all", 1, "all others, in order", all},
    {"several", 2, "10 and 37 of 1,000; 50 in one pass", several},
    {"ties", 1, "points at the same distance", ties},
    {"in-order", 1, "points that come in order; 50 in one pass",
     in_order},
    {"large", 1, "distances beyond the unit square", large},
    {"time", 3, "8 of 200,000, in twice the time for one", in_time},
    {0},
};
