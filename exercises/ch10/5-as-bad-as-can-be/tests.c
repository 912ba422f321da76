// Tests of the worst case: the corners of the hull, and where the
// points are that are none.
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>

static struct points given;

static double turn(uint32_t i, uint32_t j, uint32_t k)
{
    const double *x = given.x, *y = given.y;
    return (x[j] - x[i]) * (y[k] - y[i]) -
           (y[j] - y[i]) * (x[k] - x[i]);
}

static int compare(const void *a, const void *b)
{
    uint32_t i = *(const uint32_t *)a, j = *(const uint32_t *)b;
    if (given.x[i] != given.x[j])
        return given.x[i] < given.x[j] ? -1 : 1;
    return (given.y[i] > given.y[j]) - (given.y[i] < given.y[j]);
}

// The corner after point i, counterclockwise: no point is to the right
// of the line that leads there, and none on it is further away.
static uint32_t next_corner(uint32_t i)
{
    uint32_t best = i;
    for (uint32_t k = 0; k < given.n; k++) {
        double bend = best == i ? -1 : turn(i, best, k);
        double ahead = fabs(given.x[k] - given.x[i]) +
                       fabs(given.y[k] - given.y[i]);
        double there = fabs(given.x[best] - given.x[i]) +
                       fabs(given.y[best] - given.y[i]);
        if (ahead > 0 && (bend < 0 || (bend == 0 && ahead > there)))
            best = k;
    }
    return best;
}

// What becomes of the points.
struct census {
    uint32_t corners, along, inside, duplicates;
    uint32_t shallow; // hardly inside
    uint32_t witness; // one that is along a side, or else inside
};

static bool lies_along(const uint32_t *corner, uint32_t count,
                       uint32_t i)
{
    for (uint32_t c = 0; c < count; c++)
        if (turn(corner[c], corner[(c + 1) % count], i) == 0)
            return true;
    return false;
}

// No more than rounding can move a point, and a little.
static bool is_shallow(const uint32_t *corner, uint32_t count,
                       uint32_t i)
{
    for (uint32_t c = 0; c < count; c++) {
        uint32_t j = corner[c], k = corner[(c + 1) % count];
        if (turn(j, k, i) < 1.5 * hypot(given.x[k] - given.x[j],
                                        given.y[k] - given.y[j]))
            return true;
    }
    return false;
}

static bool is_corner(const uint32_t *corner, uint32_t count,
                      uint32_t i)
{
    for (uint32_t c = 0; c < count; c++)
        if (corner[c] == i)
            return true;
    return false;
}

static struct census take_census(void)
{
    uint32_t n = given.n, m = 0, count = 0;
    uint32_t *order = kit_input("order", n, sizeof *order);
    uint32_t *corner = kit_input("corner", n, sizeof *corner);
    for (uint32_t i = 0; i < n; i++)
        order[i] = i;
    qsort(order, n, sizeof *order, compare);
    for (uint32_t s = 0; s < n; s++)
        if (m == 0 || compare(&order[m - 1], &order[s]) != 0)
            order[m++] = order[s];
    uint32_t i = order[0];
    do {
        corner[count++] = i;
        i = next_corner(i);
    } while (compare(&i, &order[0]) != 0 && count < n);
    struct census census = {.corners = count, .duplicates = n - m};
    for (uint32_t s = 0; s < m; s++) {
        if (is_corner(corner, count, order[s]))
            continue;
        bool along = lies_along(corner, count, order[s]);
        if (along || census.along == 0)
            census.witness = order[s];
        census.along += along;
        census.inside += !along;
        census.shallow += !along && is_shallow(corner, count, order[s]);
    }
    return census;
}

static void check_places(uint32_t side)
{
    for (uint32_t i = 0; i < given.n; i++) {
        double x = given.x[i], y = given.y[i];
        bool set = x == 0 || fabs(x) > 1e-100; // as nonsense is not
        if (!(x >= 0 && x <= side && y >= 0 && y <= side))
            WRONG(.where = kit_text("point %u", i),
                  .expected = kit_text("x and y from 0 to %u", side),
                  .found = kit_point(given, i),
                  .cause =
                      !set ? "Was it ever set?"
                           : "It lies outside of the box. The steps to "
                             "the right must not sum to more than the "
                             "side, nor those upward, and the first "
                             "point needs room to its left.");
        if (x != floor(x) || y != floor(y))
            WRONG(.where = kit_text("point %u", i),
                  .expected = "whole numbers",
                  .found = kit_point(given, i),
                  .cause = "Round them. Does it stay a corner?");
    }
}

static const char *cause(struct census census)
{
    if (3 * census.along > census.corners &&
        census.along >= census.inside / 2)
        return "Points along a side are no corners: steps of the same "
               "direction are one side.";
    if (2 * census.inside > census.corners &&
        2 * census.shallow > census.inside)
        return "Most others are inside of the hull, but only just: "
               "rounding has moved them there.";
    if (2 * census.inside > census.corners)
        return "Most others are well inside of the hull. Was nothing "
               "done to place them on it, or are the sides not in the "
               "order of their angles?";
    return "Nothing is wrong with these corners, but there is room "
           "for more of them. Is the box used up to all four sides, "
           "and how long are the sides of the hull?";
}

static void check(uint32_t n, uint32_t side, uint32_t wanted)
{
    kit_next_case();
    given = (struct points){
        n,
        kit_output("points.x", n, sizeof(double)),
        kit_output("points.y", n, sizeof(double)),
    };
    kit_given("%u points, a side of %u", n, side);
    CALL(STUDENT(worst_case)(given, side));
    check_places(side);
    struct census census = take_census();
    if (census.corners >= wanted)
        return;
    bool others = census.along + census.inside > 0;
    WRONG(.where = others ? kit_text("such as %s",
                                     kit_point(given, census.witness))
                          : NULL,
          .expected = kit_text("%u corners", wanted),
          .found = kit_text("%u corners, %u points along the sides, %u "
                            "inside, and %u in the place of another",
                            census.corners, census.along, census.inside,
                            census.duplicates),
          .cause = cause(census));
}

static void hundred(uint64_t seed)
{
    (void)seed;
    check(1000, 1000, 100);
}

static void two_hundred(uint64_t seed)
{
    (void)seed;
    check(1000, 1000, 200);
}

static void most(uint64_t seed)
{
    (void)seed;
    check(1000, 1000, 340);
}

static void other_boxes(uint64_t seed)
{
    static const struct {
        uint32_t side, wanted;
    } boxes[] = {{10, 14}, {12, 14},  {20, 21},  {30, 28},
                 {60, 46}, {100, 68}, {300, 140}};
    (void)seed;
    for (int k = 0; k < 7; k++)
        check(200, boxes[k].side, boxes[k].wanted);
}

const struct kit_test kit_tests[] = {
    {"hundred", 2, "a hundred corners", hundred},
    {"two-hundred", 2, "two hundred corners", two_hundred},
    {"most", 4, "340 corners", most},
    {"other-boxes", 2, "sides from 10 to 300", other_boxes},
    {0},
};
