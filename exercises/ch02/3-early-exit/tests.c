// Tests of the early exit: answers, and the count of the distances
// measured, against a search in the points' own order and against the
// searches that students write instead; and how the count grows.
#include "common/geometry.h"
#include "exercise.h"
#include "kit.h"

// All that measure() knows: the points, how many distances were
// measured for each, and the point that it is asked for.
static struct points set;
static uint64_t *measured;
static uint32_t asked;

static double between(struct points points, uint32_t i, uint32_t j)
{
    return distance2(points.x[j] - points.x[i],
                     points.y[j] - points.y[i]);
}

double measure(uint32_t i, uint32_t j)
{
    measured[asked]++;
    return between(set, i, j);
}

enum rule { RIGHT, NOT_SQUARED, BREAK, SIGNED, TIES, ITSELF };

struct result {
    uint32_t nearest;
    uint64_t count;
};

static struct result search(struct points points, uint32_t i,
                            enum rule rule)
{
    struct result result = {i, 0};
    double best2 = INFINITY;
    for (uint32_t j = 0; j < points.n; j++) {
        double dx = points.x[j] - points.x[i];
        bool skip = rule == NOT_SQUARED ? fabs(dx) >= best2
                    : rule == SIGNED    ? dx >= sqrt(best2)
                    : rule == TIES      ? dx * dx > best2
                                        : dx * dx >= best2;
        if (skip && rule == BREAK && j != i)
            break;
        if (skip || (j == i && rule != ITSELF))
            continue;
        result.count++;
        double d2 = between(points, i, j);
        if (d2 < best2 && j != i) {
            result.nearest = j;
            best2 = d2;
        }
    }
    return result;
}

static const char *wrong_cause(struct points points, uint32_t i,
                               uint32_t right, uint32_t found)
{
    if (found == i)
        return "A point is not its own neighbor.";
    if (found >= points.n)
        return "No point was ever taken for the nearest.";
    if (between(points, i, found) == between(points, i, right))
        return "These tie: the lower index is asked for. A comparison "
               "with <= keeps the last.";
    if (found == search(points, i, NOT_SQUARED).nearest)
        return "This is found by comparing dx with the square of the "
               "best distance: square dx, too.";
    if (found == search(points, i, BREAK).nearest)
        return "The first point too far away in x ends the search, "
               "though a later one may be near: skip only that point.";
    return "The neighbor was skipped or never looked at: may dx alone "
           "rule it out?";
}

static const char *cost_cause(struct points points, uint32_t i,
                              uint64_t count)
{
    if (count == 0)
        return "Only measure() may compute a distance.";
    if (count >= points.n - 1)
        return "Is every distance measured before dx is looked at?";
    if (count == search(points, i, ITSELF).count)
        return "The distance of the point to itself is measured, too.";
    if (count == search(points, i, SIGNED).count)
        return "Points to the left are measured wherever they are: "
               "their dx is negative, its square is not.";
    if (count == search(points, i, NOT_SQUARED).count)
        return "dx is compared with the square of the best distance: "
               "square dx, too.";
    if (count == search(points, i, TIES).count)
        return "A point whose dx is as long as the best distance "
               "cannot win: measure only if the square of dx is "
               "smaller.";
    return "A point whose dx, squared, is not below the best squared "
           "distance need not be measured.";
}

static void ask_for_all(struct points points)
{
    uint32_t *found = kit_output("the answer", points.n, sizeof *found);
    measured = kit_output("the counts", points.n, sizeof *measured);
    for (uint32_t i = 0; i < points.n; i++)
        measured[i] = 0;
    set = points;
    CALL(for (asked = 0; asked < set.n; asked++) found[asked] =
             STUDENT(nearest_early)(set.n, set.x, asked));
    for (uint32_t i = 0; i < points.n; i++) {
        uint32_t right = search(points, i, RIGHT).nearest;
        if (found[i] != right)
            WRONG(.where = kit_point(points, i),
                  .expected = kit_point(points, right),
                  .found = kit_point(points, found[i]),
                  .cause = wrong_cause(points, i, right, found[i]),
                  .picture = {points, {i, found[i]}, {i, right}});
    }
}

static void count_for_all(struct points points)
{
    ask_for_all(points);
    for (uint32_t i = 0; i < points.n; i++) {
        uint64_t enough = search(points, i, RIGHT).count;
        if (measured[i] > enough || measured[i] == 0)
            WRONG(.where = kit_point(points, i),
                  .expected = kit_text("at most %ju distances measured",
                                       (uintmax_t)enough),
                  .found = kit_text("%ju", (uintmax_t)measured[i]),
                  .cause = cost_cause(points, i, measured[i]));
    }
}

static void right(uint64_t seed)
{
    ask_for_all(kit_points("uniform", 2, seed));
    kit_next_case();
    ask_for_all(kit_points("uniform", 500, seed));
    kit_next_case();
    ask_for_all(kit_points("clustered", 500, seed));
}

static void ties(uint64_t seed)
{
    ask_for_all(kit_points("lattice", 100, seed));
}

static struct points column(uint64_t seed)
{
    struct points points = kit_points("uniform", 100, seed);
    for (uint32_t i = 0; i < points.n; i++)
        points.x[i] = 0.5;
    kit_given("100 points, all with the same x");
    return points;
}

static void same_x(uint64_t seed)
{
    ask_for_all(column(seed));
}

static void large(uint64_t seed)
{
    struct points points = kit_points("uniform", 200, seed);
    for (uint32_t i = 0; i < points.n; i++)
        points.x[i] *= 1e3, points.y[i] *= 1e3;
    kit_given("200 points, uniform, in a square of side 1000");
    count_for_all(points);
}

static void count_uniform(uint64_t seed)
{
    count_for_all(kit_points("uniform", 1000, seed));
}

static void count_lattice(uint64_t seed)
{
    count_for_all(kit_points("lattice", 400, seed));
}

static void growth(uint64_t seed)
{
    enum { SETS = 5 };
    double n[SETS], count[SETS];
    for (int s = 0; s < SETS; s++) {
        n[s] = 100 << s;
        count[s] = 0;
        struct points points = kit_points("uniform", 100u << s, seed);
        ask_for_all(points);
        for (uint32_t i = 0; i < points.n; i++)
            count[s] += (double)measured[i];
        count[s] /= n[s];
        kit_next_case();
    }
    double slope = kit_growth(SETS, n, count);
    kit_given("100 to 1,600 points, uniform");
    kit_bands(slope, (struct kit_band[]){{0.6, 2}, {0.9, 1}, {0, 0}},
              (struct kit_fault){
                  .expected = "a count for each point that grows like "
                              "the square root of n, or n to the 0.6",
                  .found = kit_text("n to the %.2f", slope),
                  .cause = "The better the best so far, the narrower "
                           "the strip: on both sides of the point, "
                           "and with the best so far, not the first."});
}

const struct kit_test kit_tests[] = {
    {"right", 2, "the right neighbors", right},
    {"ties", 1, "the lowest index if several tie", ties},
    {"same-x", 1, "where x decides nothing", same_x},
    {"large", 1, "coordinates up to a thousand", large},
    {"count", 2, "few distances, 1,000 uniform points", count_uniform},
    {"count-lattice", 1, "few distances, on a lattice", count_lattice},
    {"growth", 2, "the count grows more slowly than n", growth},
    {0},
};
