// Tests of the join: the distances, against all pairs, and how the
// count of those measured grows, on points that crowd at the border.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 8192 };
static struct halved *half[2];
static uint32_t count[2];
static double right2[2][MOST]; // what is right
static uint64_t *measured;

static double between(const struct halved *p, const struct halved *q)
{
    double dx = p->x - q->x, dy = p->y - q->y;
    return dx * dx + dy * dy;
}

double measure(uint32_t i, uint32_t j)
{
    ++*measured;
    if (i >= count[0] || j >= count[1])
        kit_leave();
    return between(&half[0][i], &half[1][j]);
}

// ---- inputs --------------------------------------------------------
static int by_y(const void *one, const void *other)
{
    const struct halved *a = one, *b = other;
    return (a->y > b->y) - (a->y < b->y);
}

// Half 0 left of 0, half 1 from 0 on; width says how far they reach.
static void fill(int side, uint32_t n, double width, uint64_t seed)
{
    struct random random = {seed + side};
    half[side] =
        kit_output(side ? "right" : "left", n, sizeof *half[side]);
    count[side] = n;
    for (uint32_t k = 0; k < n; k++) {
        double x = width * (1 - random_uniform(&random));
        half[side][k] =
            (struct halved){side ? x : -x, random_uniform(&random), 0};
    }
    qsort(half[side], n, sizeof *half[side], by_y);
}

// Sorted by y, so what is too far in y may be left out.
static double nearest2_in(const struct halved *p,
                          const struct halved *half, uint32_t n)
{
    double best2 = INFINITY;
    for (const struct halved *q = half; q < half + n; q++) {
        const double dy = q->y - p->y;
        if (q != p && dy * dy <= best2)
            best2 = fmin(best2, between(p, q));
    }
    return best2;
}

static void prepare(void)
{
    for (int side = 0; side < 2; side++)
        for (uint32_t k = 0; k < count[side]; k++) {
            struct halved *p = &half[side][k];
            p->nearest2 = nearest2_in(p, half[side], count[side]);
            right2[side][k] = fmin(
                p->nearest2, nearest2_in(p, half[!side], count[!side]));
        }
}

// ---- the join ------------------------------------------------------
static const char *cause_of(int side, double expected, double found)
{
    if (found > expected)
        return side ? "The nearest of a point on the right is on the "
                      "left, and was not measured: both halves must "
                      "walk, up as well as down."
                    : "The nearest of a point on the left is on the "
                      "right, and was not measured: does the walk go "
                      "up and down, to the end of the circle?";
    return "This is less than the distance to any other point.";
}

static void check_all(void)
{
    for (int side = 0; side < 2; side++)
        for (uint32_t k = 0; k < count[side]; k++) {
            const struct halved *p = &half[side][k];
            if (p->nearest2 != right2[side][k])
                WRONG(.where = kit_text("point %u of the %s half, at "
                                        "(%g, %g)",
                                        k, side ? "right" : "left",
                                        p->x, p->y),
                      .expected = kit_text("%g", right2[side][k]),
                      .found = kit_text("%g", p->nearest2),
                      .cause =
                          cause_of(side, right2[side][k], p->nearest2));
        }
}

static void try_join(uint32_t lefts, uint32_t rights, double width,
                     uint64_t seed)
{
    kit_next_case();
    measured = kit_output("the count", 1, sizeof *measured);
    *measured = 0;
    fill(0, lefts, width, seed);
    fill(1, rights, width, seed + 100);
    prepare();
    kit_given("%u points on the left, %u on the right, up to %g from "
              "the border",
              lefts, rights, width);
    CALL(STUDENT(join)(half[0], count[0], half[1], count[1], 0));
    check_all();
}

static void small(uint64_t seed)
{
    for (uint32_t k = 2; k < 40; k++)
        try_join(k, 2 + k * 7 % 30, 1, seed + k);
}

// Right answers are not enough: at most a quarter of all pairs.
static void large(uint64_t seed)
{
    try_join(1000, 1000, 1, seed);
    if (4 * *measured > (uint64_t)count[0] * count[1])
        WRONG(.expected = "at most a quarter of the million pairs "
                          "measured",
              .found = kit_text("%ju", (uintmax_t)*measured),
              .cause =
                  "The answers are right, and were found among all "
                  "pairs. Which points of the other half can be "
                  "nearer than what is known?");
    try_join(1000, 3, 0.2, seed);
    try_join(3, 1000, 0.2, seed);
}

static void crowded(uint64_t seed)
{
    try_join(1000, 1000, 1e-3, seed);
    try_join(1000, 1000, 1e-9, seed);
}

static void few(uint64_t seed)
{
    try_join(2000, 2000, 1e-9, seed);
    if (*measured > 4 * 4000)
        WRONG(.expected = "at most 16000 distances measured",
              .found = kit_text("%ju", (uintmax_t)*measured),
              .cause = "Only what stands at a height that the circle "
                       "covers on the border need be measured.");
}

static void growth(uint64_t seed)
{
    enum { SETS = 4 };
    double n[SETS], cost[SETS];
    for (int s = 0; s < SETS; s++) {
        const uint32_t each = 1000u << s;
        try_join(each, each, 1e-3, seed);
        n[s] = 2 * each;
        cost[s] = (double)*measured;
    }
    double slope = kit_growth(SETS, n, cost);
    kit_given("2,000 to 16,000 points, all near the border");
    kit_bands(slope, (struct kit_band[]){{1.15, 3}, {1.6, 1}, {0, 0}},
              (struct kit_fault){
                  .expected = "a count that grows like n",
                  .found = kit_text("n to the %.2f", slope),
                  .cause = "Start at the point's own height, and stop "
                           "where its circle ends on the border."});
}

const struct kit_test kit_tests[] = {
    {"small", 2, "few points, joined", small},
    {"large", 2, "a thousand on a side, few pairs", large},
    {"crowded", 1, "all points close to the border", crowded},
    {"few", 2, "few distances are measured", few},
    {"growth", 3, "the count grows in proportion to n", growth},
    {0},
};
