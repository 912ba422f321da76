// Tests of the search in the tree: the distance, against all points,
// and how many leaves were measured.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>

enum { LEAF = 4, PLACES = 100 };
struct point {
    double x[2];
};

static uint32_t leaves, *measured;
static uint8_t *axis;
static double *left_high, *right_low, *found, (*places)[2];
static struct point *point;
static struct tree tree;
static uint32_t asked;
static int by;

static double apart2(const double *place, const struct point *p)
{
    const double dx = p->x[0] - place[0], dy = p->x[1] - place[1];
    return dx * dx + dy * dy;
}

static double leaf2(const double *place, uint32_t leaf)
{
    double best2 = INFINITY;
    for (uint32_t s = leaf * LEAF; s < (leaf + 1) * LEAF; s++)
        best2 = fmin(best2, apart2(place, &point[s]));
    return best2;
}

double measure_leaf(uint32_t leaf)
{
    measured[asked]++;
    return leaf2(places[asked], leaf);
}

static int compare(const void *one, const void *other)
{
    const double a = ((const struct point *)one)->x[by];
    const double b = ((const struct point *)other)->x[by];
    return (a > b) - (a < b);
}

// Sorts, halves, and goes on, x and y in turn.
static void build(uint32_t node, uint32_t first, uint32_t count,
                  int level)
{
    if (node >= leaves)
        return;
    axis[node] = (uint8_t)(level % 2);
    by = level % 2;
    qsort(point + first, count, sizeof *point, compare);
    left_high[node] = point[first + count / 2 - 1].x[axis[node]];
    right_low[node] = point[first + count / 2].x[axis[node]];
    build(2 * node, first, count / 2, level + 1);
    build(2 * node + 1, first + count / 2, count / 2, level + 1);
}

static void prepare(uint32_t count, double spread, uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    leaves = count;
    point =
        kit_input("the points", (size_t)leaves * LEAF, sizeof *point);
    axis = kit_input("axis", leaves, sizeof *axis);
    left_high = kit_input("left_high", leaves, sizeof *left_high);
    right_low = kit_input("right_low", leaves, sizeof *right_low);
    places = kit_input("the places", PLACES, sizeof *places);
    found = kit_output("the answers", PLACES, sizeof *found);
    measured = kit_output("the counts", PLACES, sizeof *measured);
    for (uint32_t s = 0; s < leaves * LEAF; s++)
        for (int k = 0; k < 2; k++)
            point[s].x[k] = random_uniform(&random);
    for (int p = 0; p < PLACES; p++)
        for (int k = 0; k < 2; k++)
            places[p][k] =
                0.5 + spread * (random_uniform(&random) - 0.5);
    build(1, 0, leaves * LEAF, 0);
    tree = (struct tree){leaves, axis, left_high, right_low};
    kit_given("%u leaves with %d points each", leaves, LEAF);
}

static void ask(void)
{
    CALL(for (asked = 0; asked < PLACES; asked++) {
        measured[asked] = 0;
        found[asked] = STUDENT(nearest2)(&tree, places[asked]);
    });
    for (int p = 0; p < PLACES; p++) {
        double right = INFINITY;
        for (uint32_t leaf = 0; leaf < leaves; leaf++)
            right = fmin(right, leaf2(places[p], leaf));
        if (found[p] != right)
            WRONG(.where = kit_text("place (%.3f, %.3f)", places[p][0],
                                    places[p][1]),
                  .expected = kit_text("%g", right),
                  .found = kit_text("%g", found[p]),
                  .cause = found[p] > right
                               ? "A side was left out that is near "
                                 "enough: are both numbers squared?"
                               : "No point is as near.");
    }
}

static void inside(uint64_t seed)
{
    for (uint32_t count = 1; count <= 256; count *= 4) {
        prepare(count, 1, seed);
        ask();
    }
}

static void outside(uint64_t seed)
{
    prepare(128, 6, seed);
    ask();
}

// ---- the count -----------------------------------------------------
static double best2, way[2];
static uint32_t needed;

static void search(const double *place, uint32_t node)
{
    if (node >= leaves) {
        needed++;
        best2 = fmin(best2, leaf2(place, node - leaves));
        return;
    }
    const int k = axis[node];
    const double to_left = place[k] - left_high[node];
    const double to_right = right_low[node] - place[k];
    const bool right = to_right < to_left;
    search(place, 2 * node + right);
    const double before = way[k];
    way[k] = fmax(before, right ? to_left : to_right);
    if (way[0] * way[0] + way[1] * way[1] < best2)
        search(place, 2 * node + !right);
    way[k] = before;
}

static void count(uint64_t seed)
{
    double all = 0, enough = 0;
    for (int trial = 0; trial < 4; trial++) {
        prepare(1024, trial % 2 ? 3 : 1, seed + trial);
        ask();
        for (int p = 0; p < PLACES; p++) {
            best2 = INFINITY;
            way[0] = way[1] = 0;
            needed = 0;
            search(places[p], 1);
            all += measured[p];
            enough += needed;
        }
    }
    const double times = all / enough;
    kit_bands(times, (struct kit_band[]){{1, 6}, {1.5, 3}, {0, 0}},
              (struct kit_fault){
                  .expected = kit_text("%.1f leaves for a place",
                                       enough / 4 / PLACES),
                  .found = kit_text("%.1f leaves for a place, %.2f "
                                    "times as many",
                                    all / 4 / PLACES, times),
                  .cause = times > 60 ? "Leave out what cannot be "
                                        "nearer than the best so far."
                                      : "Take the nearer side first, "
                                        "and add up the ways along "
                                        "both axes."});
}

const struct kit_test kit_tests[] = {
    {"inside", 2, "places among the points", inside},
    {"outside", 2, "places far outside", outside},
    {"count", 6, "few leaves measured", count},
    {0},
};
