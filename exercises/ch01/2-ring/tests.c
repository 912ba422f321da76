// Tests of the ring: where the points lie, and how many lie in pieces
// of the same area. Deviations of five standard deviations fail.
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <string.h>

enum { SAMPLE = 20000, PIECES = 10 };
static const double deviations = 5;

struct ring {
    double inner, outer;
};

// Which of the PIECES rings of the same area r is in.
static int piece_of(struct ring ring, double r)
{
    double share = (r * r - ring.inner * ring.inner) /
                   (ring.outer * ring.outer - ring.inner * ring.inner);
    return (int)fmin(fmax(share * PIECES, 0), PIECES - 1);
}

static double edge_of(struct ring ring, int piece)
{
    return sqrt(ring.inner * ring.inner +
                (ring.outer * ring.outer - ring.inner * ring.inner) *
                    piece / PIECES);
}

static int eighth_of(double x, double y)
{
    double eighths = (atan2(y, x) / acos(-1) + 1) * 4;
    return (int)fmin(fmax(eighths, 0), 7);
}

static struct points ask(struct ring ring, uint32_t n, uint64_t seed)
{
    struct points points = {
        .n = n,
        .x = kit_output("points.x", n, sizeof(double)),
        .y = kit_output("points.y", n, sizeof(double)),
    };
    kit_given("%u points, radii %g and %g", n, ring.inner, ring.outer);
    CALL(STUDENT(fill_ring)(points, ring.inner, ring.outer, seed));
    return points;
}

// Does the count of n points differ from its share by too much?
static bool unlikely(double count, double n, double share)
{
    return fabs(count - n * share) >
           deviations * sqrt(n * share * (1 - share));
}

static void check_inside(struct ring ring, uint64_t seed)
{
    struct points points = ask(ring, 2000, seed);
    for (uint32_t i = 0; i < points.n; i++) {
        double r = hypot(points.x[i], points.y[i]);
        if (r >= ring.inner * (1 - 1e-12) &&
            r <= ring.outer * (1 + 1e-12))
            continue;
        WRONG(.where = kit_point(points, i),
              .expected = kit_text("a radius from %g to %g", ring.inner,
                                   ring.outer),
              .found = kit_text("%.9g", r),
              .cause = r < ring.inner
                           ? "It lies inside the hole: does the inner "
                             "radius have a say?"
                       : r > 10 * ring.outer || isnan(r)
                           ? "Was this coordinate ever set?"
                           : "It lies outside: a corner of a square, "
                             "perhaps.");
    }
    kit_next_case();
}

static void inside(uint64_t seed)
{
    check_inside((struct ring){1, 2}, seed);
    check_inside((struct ring){0, 1}, seed);
    check_inside((struct ring){99, 100}, seed);
}

// Drawn by these rules instead, how much of a sample would lie in the
// ring between the radii a and b?
static double by_radius(struct ring ring, double a, double b)
{
    return (b - a) / (ring.outer - ring.inner);
}

static double by_squeezing(struct ring ring, double a, double b)
{
    double width = ring.outer - ring.inner;
    a -= ring.inner;
    b -= ring.inner;
    return (b * b - a * a) / (width * width);
}

static const char *area_cause(struct ring ring, const int *count)
{
    bool radius = true, squeezed = true;
    for (int p = 0; p < PIECES; p++) {
        double a = edge_of(ring, p), b = edge_of(ring, p + 1);
        radius &= !unlikely(count[p], SAMPLE, by_radius(ring, a, b));
        squeezed &=
            !unlikely(count[p], SAMPLE, by_squeezing(ring, a, b));
    }
    if (radius)
        return "It looks as if the radius itself was drawn evenly; "
               "but the area grows with its square.";
    if (squeezed)
        return "It looks like an even disc, squeezed into the ring "
               "afterward: the hole must be part of the formula.";
    return "The area within radius r grows with the square of r: "
           "which quantity should be even?";
}

static void check_area(struct ring ring, uint64_t seed)
{
    struct points points = ask(ring, SAMPLE, seed);
    int count[PIECES] = {0};
    for (uint32_t i = 0; i < points.n; i++)
        count[piece_of(ring, hypot(points.x[i], points.y[i]))]++;
    for (int p = 0; p < PIECES; p++)
        if (unlikely(count[p], SAMPLE, 1.0 / PIECES))
            WRONG(.where =
                      kit_text("between the radii %.6g and %.6g",
                               edge_of(ring, p), edge_of(ring, p + 1)),
                  .expected =
                      kit_text("about %d points", SAMPLE / PIECES),
                  .found = kit_text("%d", count[p]),
                  .cause = area_cause(ring, count));
    kit_next_case();
}

static void disc(uint64_t seed)
{
    check_area((struct ring){0, 1}, seed);
}

static void area(uint64_t seed)
{
    check_area((struct ring){1, 2}, seed);
    check_area((struct ring){0.1, 3}, seed);
    check_area((struct ring){99, 100}, seed);
}

static void directions(uint64_t seed)
{
    struct ring ring = {1, 2};
    struct points points = ask(ring, SAMPLE, seed);
    int count[8] = {0}, both[PIECES][8] = {{0}};
    for (uint32_t i = 0; i < points.n; i++) {
        int eighth = eighth_of(points.x[i], points.y[i]);
        count[eighth]++;
        both[piece_of(ring, hypot(points.x[i], points.y[i]))][eighth]++;
    }
    for (int e = 0; e < 8; e++)
        if (unlikely(count[e], SAMPLE, 1.0 / 8))
            WRONG(.where = kit_text("directions from %d to %d degrees",
                                    45 * e - 180, 45 * e - 135),
                  .expected = kit_text("about %d points", SAMPLE / 8),
                  .found = kit_text("%d", count[e]),
                  .cause = "Not all directions are equally likely: "
                           "is it the full circle?");
    for (int p = 0; p < PIECES; p++)
        for (int e = 0; e < 8; e++)
            if (unlikely(both[p][e], SAMPLE, 1.0 / (8 * PIECES)))
                WRONG(.where = kit_text(
                          "directions from %d to %d degrees, between "
                          "the radii %.6g and %.6g",
                          45 * e - 180, 45 * e - 135, edge_of(ring, p),
                          edge_of(ring, p + 1)),
                      .expected = kit_text("about %d points",
                                           SAMPLE / (8 * PIECES)),
                      .found = kit_text("%d", both[p][e]),
                      .cause = "Radius and direction depend on each "
                               "other, or the radius is not even by "
                               "area.");
}

static bool same(struct points a, struct points b)
{
    return memcmp(a.x, b.x, a.n * sizeof *a.x) == 0 &&
           memcmp(a.y, b.y, a.n * sizeof *a.y) == 0;
}

static void seeds(uint64_t seed)
{
    struct ring ring = {1, 2};
    struct points first = ask(ring, 100, seed);
    struct points again = ask(ring, 100, seed);
    struct points other = ask(ring, 100, seed + 1);
    if (!same(first, again))
        WRONG(.expected = "the same points from the same seed",
              .found = "others",
              .cause = "All randomness must come from one struct "
                       "random that begins with the seed.");
    if (same(first, other))
        WRONG(.expected = "other points from another seed",
              .found = "the same points from both",
              .cause = "The seed is not used.");
}

const struct kit_test kit_tests[] = {
    {"inside", 1, "every point lies in the ring", inside},
    {"disc", 1, "evenly by area, without a hole", disc},
    {"area", 4, "evenly by area", area},
    {"directions", 2, "in all directions alike", directions},
    {"seeds", 2, "the seed decides, and only it", seeds},
    {0},
};
