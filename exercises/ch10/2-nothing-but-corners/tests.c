// Tests of the hull: what must hold of its corners, one after the
// other, and the furthest points among them against a search of all.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>

static struct points given;

// What the student's process leaves behind.
static struct notes {
    uint64_t turns, most_measured;
    uint64_t measured;
    bool no_point;
} * notes;
static uint32_t *count, *corner, *found;

static void need_points(uint32_t i, uint32_t j, uint32_t k)
{
    uint32_t n = given.n;
    if (i < n && j < n && k < n)
        return;
    notes->no_point = true;
    kit_leave();
}

static double turn_of(uint32_t i, uint32_t j, uint32_t k)
{
    const double *x = given.x, *y = given.y;
    return (x[j] - x[i]) * (y[k] - y[i]) -
           (y[j] - y[i]) * (x[k] - x[i]);
}

static double between(uint32_t i, uint32_t j)
{
    double dx = given.x[j] - given.x[i], dy = given.y[j] - given.y[i];
    return dx * dx + dy * dy;
}

double turn(struct points points, uint32_t i, uint32_t j, uint32_t k)
{
    (void)points;
    need_points(i, j, k);
    notes->turns++;
    return turn_of(i, j, k);
}

double measure(struct points points, uint32_t i, uint32_t j)
{
    (void)points;
    need_points(i, j, i);
    notes->measured++;
    return between(i, j);
}

static int compare(const void *a, const void *b)
{
    uint32_t i = *(const uint32_t *)a, j = *(const uint32_t *)b;
    if (given.x[i] != given.x[j])
        return given.x[i] < given.x[j] ? -1 : 1;
    if (given.y[i] != given.y[j])
        return given.y[i] < given.y[j] ? -1 : 1;
    return (i > j) - (i < j);
}

void sort_by_x(struct points points, uint32_t *order)
{
    for (uint32_t i = 0; i < points.n; i++)
        order[i] = i;
    qsort(order, points.n, sizeof *order, compare);
}

// ---- inputs --------------------------------------------------------

static void take(uint32_t n)
{
    kit_next_case();
    given = (struct points){n, kit_input("points.x", n, sizeof(double)),
                            kit_input("points.y", n, sizeof(double))};
}

static void take_random(uint32_t n, uint32_t side, uint64_t seed)
{
    struct random random = {seed};
    take(n);
    for (uint32_t i = 0; i < n; i++) {
        given.x[i] = random_bits(&random) % side;
        given.y[i] = random_bits(&random) % side;
    }
    kit_given("%u points on whole numbers from 0 to %u", n, side - 1);
}

// On a circle, but for the rounding.
static void take_circle(uint32_t n, uint64_t seed)
{
    struct random random = {seed};
    take(n);
    for (uint32_t i = 0; i < n; i++) {
        double x, y;
        random_direction(&random, &x, &y);
        given.x[i] = round(0x1p20 * (1 + x));
        given.y[i] = round(0x1p20 * (1 + y));
    }
    kit_given("%u points on a circle, rounded to whole numbers", n);
}

// Along a line, in no order, and some of them twice.
static void take_line(uint32_t n, int dx, int dy)
{
    take(n);
    for (uint32_t i = 0; i < n; i++) {
        uint32_t k = i * 5 % n / 2;
        given.x[i] = 100 + (double)dx * k;
        given.y[i] = 100 + (double)dy * k;
    }
    kit_given("%u points along a line, in steps of (%d, %d)", n, dx,
              dy);
}

// ---- checks --------------------------------------------------------

static bool same_place(uint32_t i, uint32_t j)
{
    return given.x[i] == given.x[j] && given.y[i] == given.y[j];
}

static uint32_t first_in_place(uint32_t i)
{
    uint32_t j = 0;
    while (!same_place(i, j))
        j++;
    return j;
}

static void prepare(void)
{
    notes = kit_output("the counts", 1, sizeof *notes);
    *notes = (struct notes){0};
    count = kit_output("how many", 1, sizeof *count);
    corner = kit_output("corner", (size_t)given.n + 1, sizeof *corner);
}

static void check_indices(void)
{
    if (notes->no_point)
        WRONG(.expected = "indices of points",
              .found = "a function called with another number",
              .cause = "A stack with fewer than two points on it has "
                       "no last two: is that asked first?");
    if (*count < 1 || *count > given.n)
        WRONG(.expected = kit_text("1 to %u corners", given.n),
              .found = kit_text("%u", *count),
              .cause = *count == given.n + 1
                           ? "The first corner is the last one, too: "
                             "it was counted twice."
                           : "No set of points has so many corners, or "
                             "none.");
    for (uint32_t c = 0; c < *count; c++)
        if (corner[c] >= given.n)
            WRONG(.where = kit_text("corner[%u]", c),
                  .expected = "the index of a point",
                  .found = kit_text("%u", corner[c]),
                  .cause = "Was it ever set?");
}

static void check_twice(void)
{
    uint32_t last = corner[*count - 1];
    if (*count > 1 && last == corner[0])
        WRONG(.where = kit_text("corner[%u]", *count - 1),
              .expected = "every corner once",
              .found = kit_point(given, last),
              .cause = "This is where it began: the way back ends with "
                       "the first corner, which is there already.");
    for (uint32_t c = 1; c < *count; c++) {
        if (!same_place(corner[c], corner[c - 1]))
            continue;
        bool itself = corner[c] == corner[c - 1];
        WRONG(.where = kit_text("corner[%u]", c),
              .expected = "every corner once",
              .found = kit_point(given, corner[c]),
              .cause = itself ? "This is the corner before, once more: "
                                "where the way turns back, its point "
                                "is on the stack already."
                              : "It stands in the same place as the "
                                "corner before. Duplicates have to go "
                                "before anything turns.");
    }
}

static void check_first(void)
{
    uint32_t right = corner[0];
    for (uint32_t i = 0; i < given.n; i++)
        if (compare(&i, &right) < 0)
            right = i;
    if (!same_place(right, corner[0]))
        WRONG(.where = "corner[0]", .expected = kit_point(given, right),
              .found = kit_point(given, corner[0]),
              .cause = "The leftmost point comes first, the lowest of "
                       "these.");
}

static const char *tell_bend(uint32_t i, uint32_t j, uint32_t k)
{
    return kit_text("%s, between (%.9g, %.9g) and (%.9g, %.9g)",
                    kit_point(given, j), given.x[i], given.y[i],
                    given.x[k], given.y[k]);
}

static void check_bends(void)
{
    for (uint32_t c = 0; c<*count && * count> 2; c++) {
        uint32_t i = corner[c], j = corner[(c + 1) % *count];
        uint32_t k = corner[(c + 2) % *count];
        double bend = turn_of(i, j, k);
        if (bend > 0)
            continue;
        WRONG(.where = tell_bend(i, j, k), .expected = "a left turn",
              .found = bend < 0 ? "a right turn" : "neither",
              .cause =
                  bend == 0
                      ? "It lies on the line of its two neighbors, and "
                        "is no corner: the band does not bend there."
                      : "The band bends inward here, so that this is "
                        "no corner, or all go clockwise. When a point "
                        "has gone, the one before it may have to go, "
                        "too.");
    }
}

static void check_none_outside(void)
{
    for (uint32_t c = 0; c < *count; c++) {
        uint32_t i = corner[c], j = corner[(c + 1) % *count];
        for (uint32_t k = 0; k < given.n; k++) {
            if (*count == 1 ? same_place(i, k) : turn_of(i, j, k) >= 0)
                continue;
            WRONG(.where = kit_point(given, k),
                  .expected = "no point outside of the band",
                  .found = kit_text("this point, outside of the side "
                                    "from (%.9g, %.9g) to (%.9g, %.9g)",
                                    given.x[i], given.y[i], given.x[j],
                                    given.y[j]),
                  .cause = given.x[i] < given.x[j]
                               ? "A corner of the lower side is "
                                 "missing."
                               : "A corner of the upper side is "
                                 "missing, or the way back took away "
                                 "what the way there had left.");
        }
    }
}

static void check_lowest(void)
{
    for (uint32_t c = 0; c < *count; c++) {
        uint32_t right = first_in_place(corner[c]);
        if (right != corner[c])
            WRONG(.where = kit_text("corner[%u]", c),
                  .expected = kit_point(given, right),
                  .found = kit_point(given, corner[c]),
                  .cause = "Both stand there: the lowest index is "
                           "asked for. A point that follows its own "
                           "duplicate does not turn.");
    }
}

static void check_corners(void)
{
    prepare();
    CALL(*count = STUDENT(find_corners)(given, corner));
    check_indices();
    check_twice();
    check_first();
    check_bends();
    check_none_outside();
    check_lowest();
}

// Each point is put on the stack and taken away at most twice.
static void check_turns(void)
{
    check_corners();
    if (notes->turns > 4 * (uint64_t)given.n)
        WRONG(.expected =
                  kit_text("at most %u calls of turn", 4 * given.n),
              .found = kit_text("%ju", (uintmax_t)notes->turns),
              .cause =
                  "A point that has gone is never looked at again, "
                  "and only those on top of the stack are in "
                  "doubt.");
}

static uint32_t right_furthest(uint32_t i)
{
    uint32_t best = 0;
    for (uint32_t j = 1; j < given.n; j++)
        if (between(i, j) > between(i, best))
            best = j;
    return best;
}

static bool is_corner(uint32_t i)
{
    uint32_t c = 0;
    while (c < *count && corner[c] != i)
        c++;
    return c < *count;
}

static void query_all(void)
{
    *count = STUDENT(find_corners)(given, corner);
    for (uint32_t i = 0; i < given.n; i++) {
        notes->measured = 0;
        found[i] = STUDENT(furthest)(given, corner, *count, i);
        if (notes->measured > notes->most_measured)
            notes->most_measured = notes->measured;
    }
}

static void check_furthest(void)
{
    prepare();
    found = kit_output("the answers", given.n, sizeof *found);
    CALL(query_all());
    check_indices();
    for (uint32_t i = 0; i < given.n; i++) {
        uint32_t right = right_furthest(i);
        if (found[i] == right)
            continue;
        bool tie = found[i] < given.n &&
                   between(i, found[i]) == between(i, right);
        WRONG(.where = kit_point(given, i),
              .expected = kit_point(given, right),
              .found = kit_point(given, found[i]),
              .picture = {given, {i, found[i]}, {i, right}},
              .cause =
                  tie ? "These tie, and the lowest index is asked "
                        "for. The corners do not come in the "
                        "order of their indices."
                  : is_corner(right)
                      ? "The right one is among the corners, and "
                        "was not measured. Along the hull distances "
                        "may fall and rise again."
                      : "The right one is not among your corners: "
                        "first of all they must be right.");
    }
    if (notes->most_measured > *count)
        WRONG(.expected = kit_text("at most %u distances", *count),
              .found = kit_text("%ju for one query",
                                (uintmax_t)notes->most_measured),
              .cause = "Only corners need be measured, each once.");
}

// ---- tests ---------------------------------------------------------

static void few(uint64_t seed)
{
    static const int steps[][2] = {{1, 0}, {0, 1}, {2, 1}, {1, -3}};
    for (uint32_t n = 1; n <= 6; n++)
        for (uint64_t k = 0; k < 20; k++) {
            take_random(n, 1 + k % 4, seed + k);
            check_corners();
        }
    for (int k = 0; k < 4; k++) {
        take_line(24, steps[k][0], steps[k][1]);
        check_corners();
    }
}

static void scattered(uint64_t seed)
{
    take_random(300, 1 << 20, seed);
    check_turns();
    take_circle(300, seed);
    check_turns();
}

static void lattice(uint64_t seed)
{
    take_random(200, 20, seed);
    check_turns();
    take_random(300, 9, seed);
    check_turns();
    take_random(30, 5, seed);
    check_turns();
}

static void turns(uint64_t seed)
{
    take_circle(2000, seed);
    check_turns();
}

static void far_away(uint64_t seed)
{
    take_random(300, 1 << 20, seed);
    check_furthest();
    take_circle(100, seed);
    check_furthest();
    take_random(60, 1000, seed);
    for (uint32_t i = 0; i < given.n; i++)
        given.y[i] = floor(given.y[i] / 50);
    kit_given("%u points in a rectangle, much wider than high", 60);
    check_furthest();
}

static void ties(uint64_t seed)
{
    take_random(200, 7, seed);
    check_furthest();
    take_random(40, 3, seed);
    check_furthest();
}

const struct kit_test kit_tests[] = {
    {"few", 2, "a few points, in a line, in one place", few},
    {"scattered", 2, "300 points, 300 on a circle, few turns",
     scattered},
    {"lattice", 2, "along the sides, duplicates, few turns", lattice},
    {"turns", 2, "at most four turns for each point", turns},
    {"furthest", 1, "the furthest point of all queries", far_away},
    {"ties", 1, "the lowest index of several", ties},
    {0},
};
