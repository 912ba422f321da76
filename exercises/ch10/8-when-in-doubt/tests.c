// Tests of what is kept: the answers of all queries, as computed, and
// how many there are besides.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>

static struct points points;
static uint32_t *kept, *count;

static void take(uint32_t n)
{
    kit_next_case();
    points =
        (struct points){n, kit_input("points.x", n, sizeof(double)),
                        kit_input("points.y", n, sizeof(double))};
}

static void scatter(uint32_t n, double scale, uint64_t seed)
{
    struct random random = {seed};
    take(n);
    for (uint32_t i = 0; i < n; i++) {
        points.x[i] = scale * random_uniform(&random);
        points.y[i] = scale * random_uniform(&random);
    }
    kit_given("%u points in a square with the side %g", n, scale);
}

// A rectangle that is much higher than wide, and at each corner a heap
// of points that differ in their last bits; and a few inside. By so
// little the squared distance often does not change.
static void heap(uint32_t each, double scale, uint64_t seed)
{
    struct random random = {seed};
    take(4 * each);
    const double wide = 0x1p-7;
    for (uint32_t i = 0; i < points.n; i++) {
        const uint32_t where =
            i % each == 0 ? 4 : random_bits(&random) % 4;
        double u = 0x1p-49 * (random_bits(&random) % 8);
        double v = 0x1p-57 * (random_bits(&random) % 8);
        u = where & 1 ? 1 + wide - u : 1 + u;
        v = where & 2 ? 1 - 16 * v : v;
        if (where == 4) {
            u = 1 + wide * (0.2 + 0.6 * random_uniform(&random));
            v = 0.1 + 0.8 * random_uniform(&random);
        }
        points.x[i] = scale * u;
        points.y[i] = scale * v;
    }
    kit_given("%u points, most of them in heaps at the corners of a "
              "rectangle, %g by %g",
              points.n, wide * scale, scale);
}

// A needle: half of the points at its left end and half at its right
// one, above each other. Where it is thin, squared distances along it
// are all the same, as computed, though only four points are corners.
static void needle(uint32_t n, double thick, uint64_t seed)
{
    struct random random = {seed};
    take(n);
    for (uint32_t i = 0; i < n; i++) {
        points.x[i] = i % 2;
        points.y[i] = thick * (double)(random_bits(&random) % 9) / 8;
    }
    kit_given("%u points at the two ends of a needle, %g thick", n,
              thick);
}

static void lattice(uint32_t n, uint32_t columns, uint32_t rows,
                    uint64_t seed)
{
    struct random random = {seed};
    take(n);
    for (uint32_t i = 0; i < n; i++) {
        points.x[i] = random_bits(&random) % columns;
        points.y[i] = random_bits(&random) % rows;
    }
    kit_given("%u points on %u by %u places", n, columns, rows);
}

// ---- checks --------------------------------------------------------

static double between(uint32_t i, uint32_t j)
{
    return distance2(points.x[j] - points.x[i],
                     points.y[j] - points.y[i]);
}

static uint32_t furthest_from(uint32_t i)
{
    uint32_t best = 0;
    for (uint32_t j = 1; j < points.n; j++)
        if (between(i, j) > between(i, best))
            best = j;
    return best;
}

// What of it is kept.
static uint32_t furthest_kept(uint32_t i)
{
    uint32_t best = kept[0];
    for (uint32_t k = 1; k < *count; k++) {
        const uint32_t j = kept[k];
        const double d2 = between(i, j), best2 = between(i, best);
        if (d2 > best2 || (d2 == best2 && j < best))
            best = j;
    }
    return best;
}

// How far apart two points are, beside the largest distance.
static double apart(uint32_t i, uint32_t j, uint32_t from)
{
    return sqrt(between(i, j) / between(from, furthest_from(from)));
}

static const char *cause(uint32_t i, uint32_t right, uint32_t best)
{
    const double d2 = between(i, right), best2 = between(i, best);
    if (d2 == best2)
        return "As computed, both are equally far, and the one of the "
               "lower index was not kept. Next to a corner, keep what "
               "may tie with it.";
    if (apart(right, best, i) < 1e-9)
        return "The two differ by no more than rounding. As computed, "
               "a point just inside can be further than the corner: "
               "let go only what is inside by a margin.";
    return "A corner was let go. Do both chains, the lower and the "
           "upper one, keep their own?";
}

static void run(void)
{
    kept = kit_output("kept", points.n, sizeof *kept);
    count = kit_output("how many", 1, sizeof *count);
    CALL(*count = STUDENT(keep_furthest)(points, kept));
    if (*count < 1 || *count > points.n)
        WRONG(.expected = kit_text("1 to %u points", points.n),
              .found = kit_text("%u", *count));
    for (uint32_t k = 0; k < *count; k++)
        if (kept[k] >= points.n)
            WRONG(.where = kit_text("kept[%u]", k),
                  .expected = "the index of a point",
                  .found = kit_text("%u", kept[k]),
                  .cause = "Was it ever set?");
}

static void check(uint32_t most)
{
    run();
    for (uint32_t i = 0; i < points.n; i++) {
        const uint32_t right = furthest_from(i);
        const uint32_t best = furthest_kept(i);
        if (best == right)
            continue;
        WRONG(.where = kit_text("the furthest from %s",
                                kit_point(points, i)),
              .expected =
                  kit_text("point %u at (%.17g, %.17g), squared "
                           "distance %.17g",
                           right, points.x[right], points.y[right],
                           between(i, right)),
              .found = kit_text("of those kept, point %u at (%.17g, "
                                "%.17g), squared distance %.17g",
                                best, points.x[best], points.y[best],
                                between(i, best)),
              .cause = cause(i, right, best));
    }
    if (*count > most)
        WRONG(.expected = kit_text("at most %u points kept", most),
              .found = kit_text("%u", *count),
              .cause = "Most are so far inside that no rounding makes "
                       "them furthest. Is the margin too wide? It has "
                       "to be a small part of the box's own size.");
}

// How many are in the heaps, with those on the border of the inside.
static uint32_t in_heaps(void)
{
    uint32_t many = 0;
    const double scale = fabs(points.x[0]) + fabs(points.y[0]);
    double low = INFINITY, high = 0;
    for (uint32_t i = 0; i < points.n; i++) {
        low = fmin(low, points.x[i]);
        high = fmax(high, points.x[i]);
    }
    for (uint32_t i = 0; i < points.n; i++) {
        const double x = points.x[i];
        many += x - low < 1e-9 * scale || high - x < 1e-9 * scale;
    }
    return many;
}

// ---- tests ---------------------------------------------------------

static void any(uint64_t seed)
{
    for (uint32_t n = 1; n <= 12; n++) {
        scatter(n, 1, seed + n);
        check(n);
        lattice(n, 2, 3, seed + n);
        check(n);
    }
    scatter(600, 1, seed);
    check(points.n);
    lattice(600, 20, 10, seed);
    check(points.n);
    lattice(100, 30, 1, seed);
    check(points.n);
    lattice(100, 1, 30, seed);
    check(points.n);
}

static void few(uint64_t seed)
{
    scatter(3000, 1, seed);
    check(80);
    scatter(3000, 1, seed + 1);
    check(80);
}

static void heaps(uint64_t seed)
{
    for (uint64_t k = 0; k < 6; k++) {
        heap(10 << k, 1, seed + k);
        check(in_heaps());
    }
    for (int power = 20; power <= 50; power += 2) {
        needle(60, ldexp(1, -power), seed + power);
        check(points.n);
    }
}

static void scales(uint64_t seed)
{
    static const double all[] = {0x1p-300, 0x1p-30, 0x1p30, 0x1p300};
    for (int k = 0; k < 4; k++) {
        scatter(2000, all[k], seed);
        check(80);
        heap(100, all[k], seed);
        check(in_heaps());
    }
}

const struct kit_test kit_tests[] = {
    {"any", 2, "all answers are kept, of many sets", any},
    {"few", 1, "of 3,000 uniform points, at most 80", few},
    {"heaps", 4, "all answers, among points that hardly differ", heaps},
    {"scales", 3, "and in boxes of any size", scales},
    {0},
};
