// Tests of boxes in single precision: that they hold, decided for the
// real numbers, and how far a side could be moved inward.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

enum { MOST = 400 };

static int count;
static double *reach, furthest;
static struct moving (*corner)[3];
static struct float_box *box;

static void begin_case(int triangles)
{
    kit_next_case();
    count = triangles;
    reach = kit_input("reach", count, sizeof *reach);
    corner = kit_input("corner", count, sizeof *corner);
    box = kit_output("the boxes", count, sizeof *box);
}

// A triangle at a place, of a size, that moves by so much.
static void put(struct random *random, int t, double place, double size,
                double motion)
{
    double way[3];
    for (int k = 0; k < 3; k++)
        way[k] = motion * (2 * random_uniform(random) - 1);
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < 3; k++) {
            const double x =
                place + size * (2 * random_uniform(random) - 1);
            corner[t][c].begin[k] = x;
            corner[t][c].end[k] =
                x + way[k] * (1 + 0.5 * random_uniform(random));
        }
}

// ---- what is right -------------------------------------------------

// Whether low + by <= x for the real numbers: the sum is rounded, and
// rest is what it lost.
static bool is_below(double low, double by, double x)
{
    const double sum = low + by, of_by = sum - low;
    const double rest = (low - (sum - of_by)) + (by - of_by);
    return sum < x || (sum == x && rest <= 0);
}

// The largest of all numbers of single precision that will do.
static float best_below(double x, double by)
{
    float best = (float)(x - by);
    while (!is_below(best, by, x))
        best = nextafterf(best, -INFINITY);
    while (is_below(nextafterf(best, INFINITY), by, x))
        best = nextafterf(best, INFINITY);
    return best;
}

static double steps_from(float low, float best)
{
    double steps = 0;
    for (; low < best && steps < 1000; steps++)
        low = nextafterf(low, INFINITY);
    return steps;
}

// The least coordinate of a triangle, seen in a mirror if sign is -1:
// of the beginning, of the end.
static double least_of(int t, int k, int sign, bool end)
{
    double least = INFINITY;
    for (int c = 0; c < 3; c++)
        least = fmin(least, sign * (end ? corner[t][c].end[k]
                                        : corner[t][c].begin[k]));
    return least;
}

static const char *cause_of(int t, int k, int sign, double found)
{
    const double begin = least_of(t, k, sign, false);
    const double end = least_of(t, k, sign, true);
    const double x = fmin(begin, end), by = reach[t];
    if (isnan(found))
        return "That is no number.";
    if (begin > x && is_below(found, by, begin))
        return "The triangle moves on, and leaves this box before the "
               "end of the step.";
    if (end > x && is_below(found, by, end))
        return "At the beginning of the step the triangle is not in "
               "this box.";
    if (x - by == x && found == (float)x)
        return "The reach is lost: the difference in double precision "
               "is rounded, and is the coordinate itself.";
    if (found >= (float)x)
        return "This does not hold the reach.";
    if (found == (float)(x - by))
        return "The nearest number of single precision may lie inside: "
               "round outward.";
    if (x < by && found < 0.9999 * (x - by))
        return "A margin must go outward on both sides of 0.";
    return "A number of single precision lies inside.";
}

static void check_side(int t, int k, int sign)
{
    const double x =
        fmin(least_of(t, k, sign, false), least_of(t, k, sign, true));
    const float low = sign > 0 ? box[t].low[k] : -box[t].high[k];
    if (!is_below(low, reach[t], x))
        WRONG(.where = kit_text("%s, reach %g",
                                sign > 0 ? "a low side" : "a high side",
                                reach[t]),
              .expected = kit_text(
                  "%s %.17g", sign > 0 ? "at most" : "at least",
                  sign * (double)best_below(x, reach[t])),
              .found = kit_text("%.17g", sign * (double)low),
              .cause = cause_of(t, k, sign, low));
    furthest = fmax(furthest, steps_from(low, best_below(x, reach[t])));
}

static void ask(void)
{
    CALL(for (int t = 0; t < count; t++) box[t] =
             STUDENT(capture)(corner[t], reach[t]));
    for (int t = 0; t < count; t++)
        for (int k = 0; k < 3; k++) {
            check_side(t, k, 1);
            check_side(t, k, -1);
        }
}

// ---- the tests -----------------------------------------------------

static void motion(uint64_t seed)
{
    struct random random = {seed};
    begin_case(MOST);
    for (int t = 0; t < count; t++) {
        reach[t] = 0.01 + 0.1 * random_uniform(&random);
        put(&random, t, t % 3 - 1, 0.3, t % 4);
    }
    ask();
}

static void scales(uint64_t seed)
{
    struct random random = {seed};
    begin_case(MOST);
    for (int t = 0; t < count; t++) {
        const double scale = ldexp(1, t % 181 - 90);
        reach[t] = scale * ldexp(0.5 + random_uniform(&random), -t % 9);
        put(&random, t, scale * (t % 5 - 2), scale, scale * (t % 2));
    }
    ask();
}

// Coordinates of single precision, far from the origin, so that the
// reach is less than double precision can subtract.
static void tiny(uint64_t seed)
{
    struct random random = {seed};
    begin_case(MOST);
    for (int t = 0; t < count; t++) {
        reach[t] = ldexp(0.5 + random_uniform(&random), -40 - t % 50);
        put(&random, t, t % 2 ? 1e6 : -1e6, 1000, t % 3);
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < 3; k++) {
                corner[t][c].begin[k] = (float)corner[t][c].begin[k];
                corner[t][c].end[k] = (float)corner[t][c].end[k];
            }
    }
    ask();
}

static void small(uint64_t seed)
{
    furthest = 0;
    motion(seed);
    scales(seed);
    tiny(seed);
    kit_bands(furthest, (struct kit_band[]){{1, 6}, {16, 3}, {0, 0}},
              (struct kit_fault){
                  .expected = "a side that can be moved inward by one "
                              "number of single precision at most",
                  .found = kit_text("by %.0f%s", furthest,
                                    furthest < 1000 ? "" : " or more"),
                  .cause = "A margin of so many parts of the largest "
                           "number is wider than what rounding takes "
                           "away here."});
}

const struct kit_test kit_tests[] = {
    {"motion", 1, "boxes hold the whole motion", motion},
    {"scales", 2, "large and small triangles", scales},
    {"tiny", 1, "a reach that rounding would swallow", tiny},
    {"small", 6, "boxes that are no larger than they must be", small},
    {0},
};
