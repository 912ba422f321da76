// Tests of the segment and the triangle, on integers: the point where
// the segment comes through the plane is computed as a fraction, and in
// the plane the segment is cut off by one edge after the other.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>

enum { MOST = 4000 };
struct place {
    int64_t x[3];
};
struct scene {
    struct place point[5];
};

static int count, now;
static struct scene *scene;
static bool *found;
static uint32_t *asked;

// ---- vectors of integers -------------------------------------------

static struct place minus(struct place a, struct place b)
{
    for (int k = 0; k < 3; k++)
        a.x[k] -= b.x[k];
    return a;
}

static struct place times(struct place a, int64_t factor)
{
    for (int k = 0; k < 3; k++)
        a.x[k] *= factor;
    return a;
}

static struct place plus(struct place a, struct place b)
{
    return minus(a, times(b, -1));
}

static int64_t dot(struct place a, struct place b)
{
    return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}

static struct place cross(struct place a, struct place b)
{
    return (struct place){{a.x[1] * b.x[2] - a.x[2] * b.x[1],
                           a.x[2] * b.x[0] - a.x[0] * b.x[2],
                           a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

static int sign(int64_t number)
{
    return (number > 0) - (number < 0);
}

static struct place normal(struct place a, struct place b,
                           struct place c)
{
    return cross(minus(b, a), minus(c, a));
}

// ---- what is given -------------------------------------------------

static bool in_range(int a)
{
    return a >= 0 && a < 5;
}

int side_of(int a, int b, int c, int d)
{
    const struct place *p = scene[now].point;
    if (!in_range(a) || !in_range(b) || !in_range(c) || !in_range(d))
        abort();
    asked[now]++;
    return sign(dot(normal(p[a], p[b], p[c]), minus(p[d], p[a])));
}

int turn_of(int a, int b, int c)
{
    const struct place *p = scene[now].point;
    if (!in_range(a) || !in_range(b) || !in_range(c))
        abort();
    asked[now]++;
    return sign(
        dot(normal(p[a], p[b], p[c]), normal(p[0], p[1], p[2])));
}

// ---- what is right -------------------------------------------------

// How far a place is inside of an edge: w times it, for a place that is
// given as w times itself.
static int64_t inside(const struct place *p, int edge, struct place at,
                      int64_t w)
{
    const struct place from = p[edge], to = p[(edge + 1) % 3];
    return dot(normal(p[0], p[1], p[2]),
               cross(minus(to, from), minus(at, times(from, w))));
}

// The part of the segment from t = low to high, fractions over the same
// kind of denominator, is cut off where it is outside of an edge.
static bool right_in_plane(const struct place *p)
{
    int64_t low = 0, low_of = 1, high = 1, high_of = 1;
    for (int edge = 0; edge < 3; edge++) {
        const int64_t a = inside(p, edge, p[3], 1);
        const int64_t b = inside(p, edge, p[4], 1);
        if (a < 0 && b < 0)
            return false;
        if (a < 0 && -a * low_of > low * (b - a)) {
            low = -a;
            low_of = b - a;
        }
        if (b < 0 && a * high_of < high * (a - b)) {
            high = a;
            high_of = a - b;
        }
    }
    return low * high_of <= high * low_of;
}

static int64_t height(const struct place *p, int end)
{
    return dot(normal(p[0], p[1], p[2]), minus(p[end], p[0]));
}

static bool is_right(const struct place *p)
{
    const int64_t a = height(p, 3), b = height(p, 4);
    if (sign(a) * sign(b) > 0)
        return false;
    if (a == 0 && b == 0)
        return right_in_plane(p);
    const int64_t w = llabs(a) + llabs(b);
    const struct place at =
        plus(times(p[3], llabs(b)), times(p[4], llabs(a)));
    for (int edge = 0; edge < 3; edge++)
        if (inside(p, edge, at, w) < 0)
            return false;
    return true;
}

// ---- the scenes ----------------------------------------------------

static int64_t random_integer(struct random *random, int most)
{
    return (int64_t)(random_bits(random) % (2 * most + 1)) - most;
}

static struct place random_place(struct random *random, int most)
{
    struct place place;
    for (int k = 0; k < 3; k++)
        place.x[k] = random_integer(random, most);
    return place;
}

static bool is_flat(const struct place *p)
{
    const struct place n = normal(p[0], p[1], p[2]);
    return dot(n, n) == 0;
}

// Whether an end is in the plane, or an edge in a plane with the line.
static bool is_special(const struct place *p)
{
    bool special = height(p, 3) == 0 || height(p, 4) == 0;
    for (int edge = 0; edge < 3; edge++)
        special |= dot(normal(p[edge], p[(edge + 1) % 3], p[3]),
                       minus(p[4], p[3])) == 0;
    return special;
}

static void make_general(struct random *random, struct place *p)
{
    do
        for (int k = 0; k < 5; k++)
            p[k] = random_place(random, 40);
    while (is_special(p));
}

// The segment meets the plane in a place of the lattice: on an edge or
// its line, in a corner, or inside; there it may end.
static void make_touching(struct random *random, struct place *p)
{
    do {
        p[0] = random_place(random, 6);
        const struct place u = random_place(random, 4);
        const struct place v = random_place(random, 4);
        p[1] = plus(p[0], times(u, 3));
        p[2] = plus(p[0], times(v, 3));
        const int i = (int)random_integer(random, 4);
        const int j = random_bits(random) % 2
                          ? 3 - i
                          : (int)(random_bits(random) % 3);
        const struct place at =
            plus(p[0], plus(times(u, i), times(v, j)));
        const struct place way = random_place(random, 5);
        const int before = random_bits(random) % 3;
        p[3] = minus(at, times(way, before));
        p[4] = plus(at, way);
    } while (is_flat(p) || (height(p, 3) == 0 && height(p, 4) == 0));
}

static void make_in_plane(struct random *random, struct place *p)
{
    do {
        const struct place o = random_place(random, 6);
        const struct place u = random_place(random, 3);
        const struct place v = random_place(random, 3);
        for (int k = 0; k < 5; k++) {
            const int64_t i = random_integer(random, 3);
            const int64_t j = random_integer(random, 3);
            p[k] = plus(o, plus(times(u, i), times(v, j)));
        }
    } while (is_flat(p));
}

static void prepare(void (*make)(struct random *, struct place *),
                    uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    count = MOST;
    scene = kit_input("the scenes", count, sizeof *scene);
    found = kit_output("the answers", count, sizeof *found);
    asked = kit_output("the counts", count, sizeof *asked);
    for (int k = 0; k < count; k++)
        make(&random, scene[k].point);
}

// ---- the tests -----------------------------------------------------

static const char *cause_of(const struct place *p, bool right)
{
    const int a = sign(height(p, 3)), b = sign(height(p, 4));
    const struct place way = minus(p[4], p[3]);
    if (dot(way, way) == 0)
        return "The segment is a point. It lies in no direction.";
    if (a == 0 && b == 0)
        return right ? "All lies in one plane, where sides tell "
                       "nothing. Look for a line that has them apart: "
                       "there is none."
                     : "All lies in one plane, where sides tell "
                       "nothing. A line along an edge, or along the "
                       "segment, has them apart.";
    if (a == b)
        return "Both ends are on one side of the triangle's plane.";
    if (right && a * b == 0)
        return "An end of the segment is in the triangle: to touch is "
               "to meet.";
    for (int edge = 0; edge < 3; edge++)
        if (dot(normal(p[edge], p[(edge + 1) % 3], p[3]), way) == 0)
            return right ? "The segment goes through an edge or a "
                           "corner: to touch is to meet."
                         : "It passes through the line of an edge, "
                           "outside of it.";
    return right ? "The segment goes through the face."
                 : "The segment goes through the plane, but beside the "
                   "triangle.";
}

static const char *text_of(const struct place *p)
{
    const char *text = "the points";
    for (int k = 0; k < 5; k++)
        text = kit_text("%s (%d, %d, %d)", text, (int)p[k].x[0],
                        (int)p[k].x[1], (int)p[k].x[2]);
    return text;
}

static void ask(void)
{
    CALL(for (now = 0; now < count; now++) {
        asked[now] = 0;
        found[now] = STUDENT(segment_meets_triangle)();
    });
    for (int k = 0; k < count; k++) {
        const bool right = is_right(scene[k].point);
        if (found[k] != right)
            WRONG(.where = text_of(scene[k].point),
                  .expected = right ? "they meet" : "they do not meet",
                  .found = found[k] ? "they meet" : "they do not meet",
                  .cause = cause_of(scene[k].point, right));
    }
}

static void general(uint64_t seed)
{
    prepare(make_general, seed);
    ask();
}

static void touching(uint64_t seed)
{
    prepare(make_touching, seed);
    ask();
}

static void plane(uint64_t seed)
{
    prepare(make_in_plane, seed);
    ask();
}

static void few(uint64_t seed)
{
    void (*make[3])(struct random *, struct place *) = {
        make_general, make_touching, make_in_plane};
    for (int part = 0; part < 3; part++) {
        prepare(make[part], seed);
        ask();
        for (int k = 0; k < count; k++) {
            const int64_t a = height(scene[k].point, 3);
            const int64_t b = height(scene[k].point, 4);
            const bool beside = sign(a) * sign(b) > 0;
            const uint32_t most = beside ? 2 : a || b ? 5 : 11;
            if (asked[k] > most)
                WRONG(.where = text_of(scene[k].point),
                      .expected = kit_text("at most %u signs", most),
                      .found = kit_text("%u", asked[k]),
                      .cause = beside ? "Two signs tell that both ends "
                                        "are on one side."
                                      : "Ask only what is not yet "
                                        "known.");
        }
    }
}

const struct kit_test kit_tests[] = {
    {"general", 3, "general position", general},
    {"touching", 3, "ends, edges and corners that touch", touching},
    {"plane", 2, "segments in the plane of the triangle", plane},
    {"few", 2, "right with few signs", few},
    {0},
};
