// Tests of what is thrown away: no corner of the hull, most of the
// rest, and the time, beside that of a sort of all points.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct points points;
static uint32_t *kept, *count;

static void take(uint32_t n)
{
    kit_next_case();
    points =
        (struct points){n, kit_input("points.x", n, sizeof(double)),
                        kit_input("points.y", n, sizeof(double))};
    kept = kit_output("kept", n, sizeof *kept);
    count = kit_output("how many", 1, sizeof *count);
}

enum shape { SQUARE, DIAMOND, DISC, CIRCLE };
static const char *const shape_names[] = {
    "a square", "a square on its corner", "a disc", "a circle"};

static void place(uint32_t i, enum shape shape, double size,
                  struct random *random)
{
    double u = 2 * random_uniform(random) - 1;
    double v = 2 * random_uniform(random) - 1;
    if (shape == DIAMOND) {
        const double w = u;
        u = (w + v) / 2, v = (w - v) / 2;
    } else if (shape != SQUARE) {
        const double r =
            shape == DISC ? sqrt(random_uniform(random)) : 1;
        random_direction(random, &u, &v);
        u *= r, v *= r;
    }
    points.x[i] = floor(size * u);
    points.y[i] = floor(size * v);
}

static void scatter(uint32_t n, enum shape shape, double size,
                    uint64_t seed)
{
    struct random random = {seed};
    take(n);
    for (uint32_t i = 0; i < n; i++)
        place(i, shape, size, &random);
    for (uint32_t tip = 0; shape == DIAMOND && tip < 4 && n > 9;
         tip++) {
        points.x[2 * tip] = tip % 2 ? 0 : tip ? size : -size;
        points.y[2 * tip] = tip % 2 ? tip > 1 ? size : -size : 0;
    }
    kit_given("%u points in %s, whole numbers up to %g", n,
              shape_names[shape], size);
}

// ---- corners -------------------------------------------------------

static double turn(uint32_t i, uint32_t j, uint32_t k)
{
    const double *x = points.x, *y = points.y;
    return (x[j] - x[i]) * (y[k] - y[i]) -
           (y[j] - y[i]) * (x[k] - x[i]);
}

static double apart2(uint32_t i, uint32_t j)
{
    const double dx = points.x[j] - points.x[i];
    const double dy = points.y[j] - points.y[i];
    return dx * dx + dy * dy;
}

// From one corner to the next, as one wraps a gift.
static uint32_t next_corner(uint32_t i)
{
    uint32_t best = i;
    for (uint32_t k = 0; k < points.n; k++) {
        if (apart2(i, k) == 0)
            continue;
        const double bend = best == i ? -1 : turn(i, best, k);
        if (bend < 0 || (bend == 0 && apart2(i, k) > apart2(i, best)))
            best = k;
    }
    return best;
}

static void need(uint32_t corner, const bool *is_kept)
{
    if (!is_kept[corner])
        WRONG(.where = kit_point(points, corner),
              .expected = "all corners of the hull among those kept",
              .found = "this one is thrown away",
              .cause = "Only what is strictly inside of an octagon of "
                       "points, or of whatever you take, is certainly "
                       "no corner. Do several of its points coincide, "
                       "or lie on a line?");
}

static void check_kept(void)
{
    bool *is_kept = kit_input("flags", points.n, sizeof *is_kept);
    memset(is_kept, 0, points.n * sizeof *is_kept);
    if (*count < 1 || *count > points.n)
        WRONG(.expected = kit_text("1 to %u points", points.n),
              .found = kit_text("%u", *count),
              .cause = "If all are in one place or on a line, none is "
                       "inside, and corners there are still.");
    for (uint32_t k = 0; k < *count; k++) {
        if (kept[k] >= points.n || is_kept[kept[k]])
            WRONG(.where = kit_text("kept[%u]", k),
                  .expected = "indices of points, each once",
                  .found = kit_text("%u", kept[k]),
                  .cause = "Is the number returned that of the indices "
                           "written?");
        is_kept[kept[k]] = true;
    }
    uint32_t first = 0;
    for (uint32_t i = 1; i < points.n; i++)
        if (points.x[i] < points.x[first] ||
            (points.x[i] == points.x[first] &&
             points.y[i] < points.y[first]))
            first = i;
    uint32_t corner = first;
    do {
        need(corner, is_kept);
        corner = next_corner(corner);
    } while (apart2(corner, first) > 0);
}

static void check(void)
{
    CALL(*count = STUDENT(throw_away)(points, kept));
    check_kept();
}

static void corners(uint64_t seed)
{
    for (int shape = SQUARE; shape <= CIRCLE; shape++) {
        scatter(2000, shape, 1 << 19, seed);
        check();
        scatter(300, shape, 1000, seed);
        check();
    }
}

static void special(uint64_t seed)
{
    for (uint32_t n = 1; n <= 30; n++)
        for (int size = 1; size <= 4; size++) {
            scatter(n, n % 4, size, seed + n);
            check();
        }
    for (int direction = 0; direction < 8; direction++) {
        scatter(40, SQUARE, 20, seed + direction);
        for (uint32_t i = 0; i < points.n; i++) {
            const double k = points.x[i];
            points.x[i] = k * (direction % 4 - 1);
            points.y[i] = k * (direction / 4 + direction % 2);
        }
        kit_given("40 points on a line");
        check();
    }
}

static void check_few(enum shape shape, double share, uint64_t seed)
{
    const uint32_t n = 50000;
    scatter(n, shape, 1 << 19, seed);
    check();
    if (*count > share * n)
        WRONG(.expected = kit_text("at most %g kept", share * n),
              .found = kit_text("%u", *count),
              .cause = "Four directions leave much of a square, or of "
                       "one that stands on its corner; eight leave a "
                       "tenth of a disc. Is a side from a point to "
                       "itself left out, and is inside to the left?");
}

static void few(uint64_t seed)
{
    check_few(SQUARE, 0.03, seed);
    check_few(DIAMOND, 0.03, seed);
    check_few(DISC, 0.15, seed);
}

// ---- time ----------------------------------------------------------

struct ordered {
    double x, y;
    uint32_t index;
};
static struct ordered *sorted;

static int compare(const void *p, const void *q)
{
    const struct ordered *a = p, *b = q;
    return (a->x > b->x) - (a->x < b->x);
}

static void theirs(void)
{
    CALL(*count = STUDENT(throw_away)(points, kept));
}

static void sort_all(void)
{
    CALL({
        for (uint32_t i = 0; i < points.n; i++)
            sorted[i] = (struct ordered){points.x[i], points.y[i], i};
        qsort(sorted, points.n, sizeof *sorted, compare);
    });
}

static void in_time(uint64_t seed)
{
    check_few(SQUARE, 1, seed);
    scatter(kit_is_sanitized() ? 1000 : 400000, SQUARE, 1 << 19, seed);
    sorted = kit_output("sorted", points.n, sizeof *sorted);
    double ratio =
        kit_race((struct kit_race){theirs, sort_all, .cores = 1});
    check_kept();
    kit_bands(ratio,
              (struct kit_band[]){{0.3, 6}, {0.5, 4}, {0.8, 2}, {0, 0}},
              (struct kit_fault){
                  .expected = "three tenths of the time of a sort",
                  .found = kit_text("%.2f of it", ratio),
                  .cause =
                      "To throw points away, none has to be sorted. Go "
                      "through all of them once to find a few that are "
                      "far out, and once more to compare."});
}

const struct kit_test kit_tests[] = {
    {"corners", 1, "no corner is thrown away", corners},
    {"special", 1, "few points, on a line, in one place", special},
    {"few", 2, "most others are, in three shapes", few},
    {"time", 6, "in three tenths of the time of a sort", in_time},
    {0},
};
