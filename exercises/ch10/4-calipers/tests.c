// Tests of the diameter: against all pairs, and the counts against the
// number of corners.
#include "common/allocate.h"
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Several hulls, which are put into one call. What the student's
// process leaves behind of each: the answer, the counts, and for every
// pair whether it was measured.
enum { HULLS_MOST = 10, CORNERS_MOST = 2000 };
struct notes {
    struct pair found;
    uint64_t measured, heights;
    bool no_corner, endless;
};
static struct hull {
    char given[80];
    uint32_t n;
    double x[CORNERS_MOST], y[CORNERS_MOST];
    bool *seen;
} hulls[HULLS_MOST];
static int hull_count;
static struct notes *all_notes;

// Of the one that is at work.
static struct points corners;
static struct notes *notes;
static bool *seen;

static void choose(int number)
{
    struct hull *hull = &hulls[number];
    kit_given("%s", hull->given);
    corners = (struct points){hull->n, hull->x, hull->y};
    notes = &all_notes[number];
    seen = hull->seen;
}

static void add_hull(uint32_t n, const char *given)
{
    struct hull *hull = &hulls[hull_count++];
    snprintf(hull->given, sizeof hull->given, "%s", given);
    hull->n = n;
    hull->seen = kit_output("seen", (size_t)n * n, sizeof(bool));
    memset(hull->seen, false, (size_t)n * n);
    corners = (struct points){n, hull->x, hull->y};
}

static void need_corners(uint32_t i, uint32_t j)
{
    if (i < corners.n && j < corners.n)
        return;
    notes->no_corner = true;
    kit_leave();
}

static double between(uint32_t i, uint32_t j)
{
    double dx = corners.x[j] - corners.x[i];
    double dy = corners.y[j] - corners.y[i];
    return dx * dx + dy * dy;
}

static double height_of(uint32_t i, uint32_t k)
{
    const double *x = corners.x, *y = corners.y;
    uint32_t j = (i + 1) % corners.n;
    return (x[j] - x[i]) * (y[k] - y[i]) -
           (y[j] - y[i]) * (x[k] - x[i]);
}

double measure(uint32_t i, uint32_t j)
{
    need_corners(i, j);
    notes->measured++;
    seen[i * corners.n + j] = seen[j * corners.n + i] = true;
    return between(i, j);
}

double height(uint32_t i, uint32_t k)
{
    need_corners(i, k);
    uint64_t n = corners.n;
    if (++notes->heights > 4 * n * n + 1000) {
        notes->endless = true;
        kit_leave();
    }
    return height_of(i, k);
}

// ---- hulls ---------------------------------------------------------

// Sides are vectors, put together in the order of their directions.
struct side {
    double x, y;
};

static double cross(struct side a, struct side b)
{
    return a.x * b.y - a.y * b.x;
}

static int compare(const void *p, const void *q)
{
    struct side a = *(const struct side *)p;
    struct side b = *(const struct side *)q;
    bool down_a = a.y < 0 || (a.y == 0 && a.x < 0);
    bool down_b = b.y < 0 || (b.y == 0 && b.x < 0);
    if (down_a != down_b)
        return down_a - down_b;
    return (cross(a, b) < 0) - (cross(a, b) > 0);
}

// The hull that has these sides, which sum to 0, but for those that
// have the same direction, which become one.
static void build(struct side *side, uint32_t count, uint32_t first,
                  bool even)
{
    uint32_t some = 0, n = 0;
    for (uint32_t s = 0; s < count; s++)
        if (side[s].x != 0 || side[s].y != 0)
            side[some++] = side[s];
    qsort(side, some, sizeof *side, compare);
    for (uint32_t s = 0; s < some; s++)
        if (n > 0 && compare(&side[s], &side[n - 1]) == 0) {
            side[n - 1].x += side[s].x;
            side[n - 1].y += side[s].y;
        } else {
            side[n++] = side[s];
        }
    add_hull(n, kit_text("a hull of %u corners%s", n,
                         even ? ", its sides parallel in pairs" : ""));
    double x = 0, y = 0;
    for (uint32_t s = 0; s < n; s++) {
        uint32_t turned = (s + first) % n;
        corners.x[s] = x;
        corners.y[s] = y;
        x += side[turned].x;
        y += side[turned].y;
    }
}

// Sides of random length and direction, within so many steps to the
// right or left and up or down; and each once more in the opposite
// direction, or one that closes the hull.
static void lay(uint32_t count, uint32_t wide, uint32_t high, bool even,
                uint64_t seed)
{
    struct random random = {seed};
    struct side *side = allocate(2 * (size_t)count, sizeof *side);
    struct side sum = {0, 0};
    for (uint32_t s = 0; s < count; s++) {
        side[s] = (struct side){
            (double)(random_bits(&random) % (2 * wide + 1)) - wide,
            (double)(random_bits(&random) % (2 * high + 1)) - high};
        sum.x += side[s].x;
        sum.y += side[s].y;
        side[count + s] = (struct side){-side[s].x, -side[s].y};
    }
    if (!even)
        side[count] = (struct side){-sum.x, -sum.y};
    build(side, even ? 2 * count : count + 1,
          random_bits(&random) % count, even);
    free(side);
}

// Hulls with three tips, nearly as wide in one direction as in another:
// on these, distances go up and down.
static const struct side tips[][8] = {{{-252, -839},
                                       {-211, -938},
                                       {-38, -872},
                                       {304, -700},
                                       {902, 195},
                                       {929, 283},
                                       {894, 300},
                                       {-706, 661}},
                                      {{452, -548},
                                       {724, -157},
                                       {879, 275},
                                       {674, 330},
                                       {-705, 635},
                                       {-355, -750},
                                       {-202, -938},
                                       {72, -811}},
                                      {{-648, -272},
                                       {-221, -944},
                                       {-12, -830},
                                       {516, -514},
                                       {908, 295},
                                       {810, 328},
                                       {-701, 686},
                                       {-722, 588}}};

static void lay_tips(const struct side *tip, uint32_t first)
{
    add_hull(8, "a hull of 8 corners, a triangle with round sides");
    for (uint32_t s = 0; s < 8; s++) {
        corners.x[s] = tip[(s + first) % 8].x;
        corners.y[s] = tip[(s + first) % 8].y;
    }
}

// ---- what is right, and what is found by mistake -------------------

enum rule { RIGHT, BY_DISTANCE, FROM_ZERO, NOT_AROUND, HALF, LAST_TOP };

static struct pair search(enum rule rule)
{
    uint32_t n = corners.n, k = rule == FROM_ZERO ? 0 : 1 % n;
    struct pair best = {.d2 = -1};
    for (uint32_t i = 0; i < (rule == HALF ? (n + 1) / 2 : n); i++) {
        for (uint32_t steps = 0; steps < n; steps++) {
            uint32_t next = (k + 1) % n;
            double more = rule == BY_DISTANCE
                              ? between(i, next) - between(i, k)
                              : height_of(i, next) - height_of(i, k);
            if (more < 0 || (more == 0 && rule != LAST_TOP) ||
                (rule == NOT_AROUND && next == 0))
                break;
            k = next;
        }
        if (between(i, k) > best.d2)
            best = (struct pair){i < k ? i : k, i < k ? k : i,
                                 between(i, k)};
    }
    return best;
}

static struct pair right_answer(void)
{
    const uint64_t n = corners.n;
    struct pair best = {0, 0, 0};
    for (uint64_t k = 0; k < n * n; k++) {
        struct pair pair = {k / n, k % n, between(k / n, k % n)};
        if (pair.i < pair.j && pair.d2 > best.d2)
            best = pair;
    }
    return best;
}

static const char *tell(struct pair pair)
{
    if (pair.i >= corners.n || pair.j >= corners.n)
        return kit_text("corners %u and %u, distance %g", pair.i,
                        pair.j, sqrt(pair.d2));
    return kit_text("corners %u at (%.9g, %.9g) and %u at (%.9g, "
                    "%.9g), squared distance %.17g",
                    pair.i, corners.x[pair.i], corners.y[pair.i],
                    pair.j, corners.x[pair.j], corners.y[pair.j],
                    pair.d2);
}

static bool found_by(enum rule rule)
{
    return notes->found.d2 == search(rule).d2;
}

static const char *wrong_cause(struct pair right)
{
    if (notes->found.i >= corners.n || notes->found.j >= corners.n)
        return "These are no corners: was any pair ever kept?";
    if (notes->found.d2 != between(notes->found.i, notes->found.j))
        return "This is not the squared distance of these two.";
    if (notes->found.d2 == right.d2 && notes->found.i > notes->found.j)
        return "The lower number comes first.";
    if (notes->found.d2 == right.d2)
        return "These tie: the lowest i is asked for, and then the "
               "lowest j. The pairs do not come in that order.";
    if (seen[right.i * corners.n + right.j])
        return "The right pair was measured, and then forgotten.";
    if (notes->measured < corners.n && found_by(HALF))
        return "This is what half of the sides find. A pair comes "
               "once only, and it may be at a later side.";
    if (notes->heights == 0 && found_by(BY_DISTANCE))
        return "This is what is found by going on as long as the "
               "distance grows. Distances along the hull may fall and "
               "rise again; heights do not.";
    if (found_by(FROM_ZERO))
        return "This is what is found from corner 0 on. It is as high "
               "above the first side as corner 1: there is no next "
               "one that is higher, and the search stands still.";
    if (found_by(NOT_AROUND))
        return "This is what is found if the way ends at the last "
               "corner. "
               "After it comes corner 0.";
    if (found_by(LAST_TOP))
        return "Above a side that is parallel to another, two corners "
               "are equally high: the first of them was passed by.";
    return "This pair was never measured. One of the two begins a "
           "side above which the other one is highest.";
}

static void check_answer(void)
{
    if (notes->no_corner)
        WRONG(.expected = kit_text("corners 0 to %u", corners.n - 1),
              .found = "a function called for another",
              .cause = "After the last corner comes corner 0.");
    if (notes->endless)
        WRONG(.expected = kit_text("at most %u heights", 8 * corners.n),
              .found = "no end of it",
              .cause = "A next corner that is just as high is not "
                       "higher. With two corners all heights are 0.");
    struct pair right = right_answer();
    if (notes->found.i != right.i || notes->found.j != right.j ||
        notes->found.d2 != right.d2)
        WRONG(.expected = tell(right), .found = tell(notes->found),
              .picture = {corners,
                          {notes->found.i, notes->found.j},
                          {right.i, right.j}},
              .cause = wrong_cause(right));
}

// Right answers are not enough: far fewer pairs than there are.
static void check_few(void)
{
    check_answer();
    const uint32_t n = corners.n;
    if (n >= 16 && notes->measured > n * n / 4)
        WRONG(.expected = kit_text("at most %u distances of %u corners",
                                   n * n / 4, n),
              .found = kit_text("%ju", (uintmax_t)notes->measured),
              .cause = "The answer is right, and was found among all "
                       "pairs. Only those between the calipers need be "
                       "measured.");
}

static void check_counts(void)
{
    check_answer();
    uint32_t n = corners.n;
    if (notes->measured > 3 * n || notes->measured == 0)
        WRONG(.expected = kit_text("1 to %u distances", 3 * n),
              .found = kit_text("%ju", (uintmax_t)notes->measured),
              .cause = notes->measured
                           ? "Of all pairs only those between the "
                             "calipers need be measured: a side's "
                             "corners and the one highest above it."
                           : "Only measure() may tell a distance.");
    if (notes->heights > 8 * n)
        WRONG(.expected = kit_text("at most %u heights", 8 * n),
              .found = kit_text("%ju", (uintmax_t)notes->heights),
              .cause = "For the next side, go on from where you are. "
                       "The highest corner never moves back.");
}

// ---- tests ---------------------------------------------------------

// All hulls that were laid.
static void check_hulls(void (*check)(void))
{
    const int count = hull_count;
    hull_count = 0;
    all_notes = kit_output("the counts", count, sizeof *all_notes);
    memset(all_notes, 0, count * sizeof *all_notes);
    CALL(for (int h = 0; h < count; h++) {
        choose(h);
        notes->found = STUDENT(diameter)(corners.n);
        check();
    });
    for (int h = 0; h < count; h++) {
        choose(h);
        check();
    }
    kit_next_case();
}

static void scattered(uint64_t seed)
{
    for (uint64_t k = 0; k < 100; k++) {
        lay(3 + k, 1000, 1000, false, seed + k);
        if (k % 10 == 9)
            check_hulls(check_few);
    }
}

static void oblong(uint64_t seed)
{
    for (uint64_t k = 0; k < 100; k++) {
        lay(3 + k / 4, k % 2 ? 40 : 500, k % 2 ? 500 : 40, false,
            seed + k);
        if (k % 10 == 9)
            check_hulls(check_few);
    }
}

static void rounded(uint64_t seed)
{
    (void)seed;
    for (int k = 0; k < 3; k++) {
        for (uint32_t first = 0; first < 8; first++)
            lay_tips(tips[k], first);
        check_hulls(check_answer);
    }
}

static void parallel(uint64_t seed)
{
    for (uint64_t k = 0; k < 60; k++) {
        lay(2 + k / 3, 60, 60, true, seed + k);
        if (k % 10 == 9)
            check_hulls(check_few);
    }
}

static void ties(uint64_t seed)
{
    for (uint64_t k = 0; k < 200; k++) {
        lay(2 + k % 8, 1 + k % 3, 1, k % 2 == 0, seed + k);
        if (corners.n <= 2)
            hull_count--;
        if (k % 10 == 9)
            check_hulls(check_answer);
    }
}

static void lay_single(void)
{
    add_hull(1, "a single corner");
    corners.x[0] = corners.y[0] = 3;
}

static void few(uint64_t seed)
{
    for (uint64_t k = 0; k < 20; k++) {
        lay(1, 100, 100, true, seed + k);
        lay(2, 100, 100, false, seed + k);
        if (k % 5 == 4)
            check_hulls(check_answer);
    }
    lay_single();
    check_hulls(check_answer);
}

static void counts(uint64_t seed)
{
    lay(1500, 1000, 1000, false, seed);
    check_hulls(check_counts);
    lay(600, 1000, 100, true, seed);
    check_hulls(check_counts);
}

const struct kit_test kit_tests[] = {
    {"scattered", 2, "hulls of all sizes, few pairs", scattered},
    {"oblong", 1, "long and thin hulls, few pairs", oblong},
    {"rounded", 1, "triangles with round sides", rounded},
    {"parallel", 1, "sides parallel in pairs, few pairs", parallel},
    {"ties", 1, "the lowest of several pairs", ties},
    {"few", 1, "one corner, two, or three", few},
    {"counts", 3, "no more steps than corners allow", counts},
    {0},
};
