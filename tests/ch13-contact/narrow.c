// The narrow phase: orientations against 128-bit integers; triangles at
// rest against Caratheodory's theorem in integers, every degenerate
// kind among them. CONTACT_PAIRS=1000000 takes so many of each kind.
#include "narrow.h"
#include "ch13-contact/triangle_pair.h"
#include <math.h>
#include <string.h>

__extension__ typedef __int128 wide;

static int sign_of(wide x)
{
    return (x > 0) - (x < 0);
}

// ---- orientations -------------------------------------------------
void ranges_are_checked(void)
{
    const double good[] = {0, -0.0, 1, -1, 0x1p-280, -0x1p+280};
    const double bad[] = {0x1p-281, -0x1p+281, NAN, INFINITY, 5e-324};
    CHECK(within_exact_bounds(good, 6), "good coordinates");
    for (int k = 0; k < 5; k++)
        CHECK(!within_exact_bounds(&bad[k], 1), "bad coordinate %d", k);
}

static int wide_orientation3(int64_t p[4][3])
{
    wide v[3][3];
    for (int k = 0; k < 3; k++)
        for (int x = 0; x < 3; x++)
            v[k][x] = (wide)p[k + 1][x] - p[0][x];
    return sign_of(v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
                   v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
                   v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]));
}

static int wide_orientation2(int64_t p[3][3])
{
    return sign_of(
        ((wide)p[1][0] - p[0][0]) * ((wide)p[2][1] - p[0][1]) -
        ((wide)p[1][1] - p[0][1]) * ((wide)p[2][0] - p[0][0]));
}

// The points with their coordinates turned around and scaled, in every
// order that begins with another point.
static void check_orientations(int64_t p[4][3], double scale,
                               uint64_t *expanded)
{
    for (int first = 0; first < 4; first++)
        for (int turn = 0; turn < 3; turn++) {
            int64_t q[4][3];
            double a[4][3];
            for (int k = 0; k < 4; k++)
                for (int x = 0; x < 3; x++) {
                    q[k][x] = p[(k + first) % 4][(x + turn) % 3];
                    a[k][x] = scale * (double)q[k][x];
                }
            CHECK_INT(wide_orientation3(q),
                      orientation3(a[0], a[1], a[2], a[3], expanded),
                      "in space, first %d turn %d", first, turn);
            CHECK_INT(wide_orientation2(q),
                      orientation2(a[0], a[1], a[2], expanded),
                      "in a plane, first %d turn %d", first, turn);
        }
}

void sides_are_exact(void)
{
    const uint32_t n = pair_count(20000);
    struct random random = {1301};
    test_seed(1301);
    uint64_t expanded = 0, easy = 0;
    static const int64_t size[] = {1, 2, 10, 1 << 19};
    for (uint32_t i = 0; i < n; i++) {
        int64_t p[4][3];
        for (int k = 0; k < 4; k++)
            for (int x = 0; x < 3; x++)
                p[k][x] = pick(&random, size[i % 4]);
        check_orientations(p, i % 3 ? 1 : 0x1p-270,
                           i % 4 == 3 ? &easy : &expanded);
    }
    CHECK(easy < n / 1000 + 2, "the filter gave up %llu times",
          (unsigned long long)easy);
}

// On a plane, or next to it. Of the first kind, differences have no
// rounding; of the second, they have.
static void nearly_flat(int64_t p[4][3], struct random *random)
{
    int64_t s[3], t[3];
    for (int x = 0; x < 3; x++) {
        p[0][x] = pick(random, (int64_t)1 << 39);
        s[x] = pick(random, 1 << 16);
        t[x] = pick(random, 1 << 16);
    }
    for (int k = 1; k < 4; k++) {
        const int64_t far = k < 3 ? 100 : (int64_t)1 << 34;
        const int64_t i = pick(random, far), j = pick(random, far);
        for (int x = 0; x < 3; x++)
            p[k][x] = p[0][x] + i * s[x] + j * t[x] +
                      (k == 3 ? pick(random, 1) : 0);
    }
}

static void flat_and_steep(int64_t p[4][3], struct random *random)
{
    const int64_t i = pick(random, (int64_t)1 << 36) * 4096;
    const int64_t j = pick(random, (int64_t)1 << 36) * 4096;
    for (int k = 1; k < 4; k++) {
        p[k][1] = pick(random, 100);
        p[k][2] = pick(random, 100);
        p[k][0] = i * p[k][1] + j * p[k][2];
    }
    p[0][0] = pick(random, 1);
    p[0][1] = p[0][2] = 0;
}

// Nearly on a line as seen from above.
static void nearly_straight(int64_t p[4][3], struct random *random)
{
    const int64_t i = pick(random, (int64_t)1 << 38) * 4096;
    const int64_t j = pick(random, (int64_t)1 << 38) * 4096;
    for (int k = 0; k < 4; k++) {
        const int64_t far = k == 0 ? 0 : pick(random, 100);
        p[k][0] = i * far + (k == 0 ? pick(random, 100) : 0);
        p[k][1] = j * far + (k == 0 ? pick(random, 100) : 0);
        p[k][2] = pick(random, 1);
    }
}

void nearly_flat_sides_are_exact(void)
{
    const uint32_t n = pair_count(20000);
    struct random random = {1302};
    test_seed(1302);
    static const double scales[] = {1, 0x1p+200, 0x1p-200};
    void (*const make[])(int64_t p[4][3], struct random *) = {
        nearly_flat, flat_and_steep, nearly_straight};
    for (int kind = 0; kind < 3; kind++) {
        uint64_t expanded = 0;
        for (uint32_t i = 0; i < n; i++) {
            int64_t p[4][3];
            make[kind](p, &random);
            check_orientations(p, scales[i % 3], &expanded);
        }
        CHECK(expanded > 4 * n, "only %llu needed expansions",
              (unsigned long long)expanded);
    }
}

// ---- triangles at rest --------------------------------------------

// Two convex bodies meet if the origin is in the hull of the
// differences of their corners; then it is in a simplex of some of them
// that is not flat (Caratheodory 1907).
static wide product(const wide a[3], const wide b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void normal(const wide a[3], const wide b[3], wide n[3])
{
    for (int x = 0; x < 3; x++)
        n[x] = a[(x + 1) % 3] * b[(x + 2) % 3] -
               a[(x + 2) % 3] * b[(x + 1) % 3];
}

static wide volume(const wide a[3], const wide b[3], const wide c[3])
{
    wide n[3];
    normal(a, b, n);
    return product(n, c);
}

static bool zero_in_segment(const wide a[3], const wide b[3])
{
    wide n[3];
    normal(a, b, n);
    return n[0] == 0 && n[1] == 0 && n[2] == 0 && product(a, b) <= 0;
}

static bool zero_in_triangle(const wide a[3], const wide b[3],
                             const wide c[3])
{
    if (volume(a, b, c) != 0)
        return false;
    wide ab[3], bc[3], ca[3], n[3];
    normal(a, b, ab);
    normal(b, c, bc);
    normal(c, a, ca);
    for (int x = 0; x < 3; x++)
        n[x] = ab[x] + bc[x] + ca[x];
    return product(n, n) != 0 && product(n, ab) >= 0 &&
           product(n, bc) >= 0 && product(n, ca) >= 0;
}

static bool zero_in_tetrahedron(const wide a[3], const wide b[3],
                                const wide c[3], const wide d[3])
{
    const int s[4] = {
        sign_of(volume(b, c, d)), sign_of(-volume(a, c, d)),
        sign_of(volume(a, b, d)), sign_of(-volume(a, b, c))};
    bool left = false, right = false;
    for (int k = 0; k < 4; k++) {
        left |= s[k] > 0;
        right |= s[k] < 0;
    }
    return left != right;
}

static bool one_side_of_zero(wide v[9][3])
{
    for (int x = 0; x < 3; x++) {
        bool left = true, right = true;
        for (int k = 0; k < 9; k++) {
            left &= v[k][x] < 0;
            right &= v[k][x] > 0;
        }
        if (left || right)
            return true;
    }
    return false;
}

static bool plainly_meet(int64_t p[3][3], int64_t q[3][3])
{
    wide v[9][3];
    for (int k = 0; k < 9; k++)
        for (int x = 0; x < 3; x++)
            v[k][x] = p[k / 3][x] - q[k % 3][x];
    if (one_side_of_zero(v))
        return false;
    for (int a = 0; a < 9; a++)
        for (int b = a; b < 9; b++) {
            if (zero_in_segment(v[a], v[b]))
                return true;
            for (int c = b + 1; c < 9 && b > a; c++) {
                if (zero_in_triangle(v[a], v[b], v[c]))
                    return true;
                for (int d = c + 1; d < 9; d++)
                    if (zero_in_tetrahedron(v[a], v[b], v[c], v[d]))
                        return true;
            }
        }
    return false;
}

enum kind {
    ANY,
    COPLANAR,
    AT_A_VERTEX,
    VERTEX_ON_FACE,
    EDGE_ON_EDGE,
    ALONG_AN_EDGE,
    NEEDLES,
    SEGMENTS,
    POINTS,
    EQUAL,
    KINDS
};
static const char *const kind_name[KINDS] = {
    "any",          "coplanar",      "at a vertex", "vertex on face",
    "edge on edge", "along an edge", "needles",     "segments",
    "points",       "equal"};

// Corner k of q becomes a + (i s + j t) / 4, where s and t lead from
// a to b and to c, which are multiples of 4.
static void put(int64_t q[3], int64_t p[3][3], int64_t i, int64_t j)
{
    for (int x = 0; x < 3; x++)
        q[x] = p[0][x] + i * (p[1][x] - p[0][x]) / 4 +
               j * (p[2][x] - p[0][x]) / 4;
}

static void make_flat(int64_t p[3][3], int64_t q[3][3],
                      struct random *random)
{
    for (int k = 0; k < 3; k++)
        put(q[k], p, pick(random, 5), pick(random, 5));
}

static void make_needle(int64_t p[3][3], struct random *random)
{
    put(p[2], p, pick(random, 6), 0);
    p[2][random_bits(random) % 3] += pick(random, 1);
}

static void make_thin(enum kind kind, int64_t p[3][3], int64_t q[3][3],
                      struct random *random)
{
    const int64_t i = random_bits(random) % 5;
    const int64_t j = random_bits(random) % (5 - i);
    switch (kind) {
    case NEEDLES:
        make_needle(p, random);
        put(q[0], p, pick(random, 3), pick(random, 1));
        if (i % 2)
            make_needle(q, random);
        break;
    case SEGMENTS:
        put(q[0], p, i, j);
        put(p[2], p, pick(random, 6), 0);
        if (i % 2) // both are
            put(q[2], q, 4 * pick(random, 2), 0);
        if (j % 2)
            put(q[0], p, i, 0);
        break;
    case POINTS:
        put(q[0], p, pick(random, 4), pick(random, 4));
        memcpy(q[1], q[0], sizeof q[0]);
        memcpy(q[2], q[0], sizeof q[0]);
        if (i == 0)
            memcpy(p[2], p[1], sizeof p[0]);
        if (j == 0)
            memcpy(p[1], p[0], sizeof p[0]);
        break;
    default:
        break;
    }
}

// From p, multiples of 4, and any q.
static void make_kind(enum kind kind, int64_t p[3][3], int64_t q[3][3],
                      struct random *random)
{
    const int64_t i = random_bits(random) % 5;
    const int64_t j = random_bits(random) % (5 - i);
    switch (kind) {
    case COPLANAR:
        make_flat(p, q, random);
        break;
    case AT_A_VERTEX:
        memcpy(q[0], p[0], sizeof q[0]);
        break;
    case VERTEX_ON_FACE:
        put(q[0], p, i, j);
        break;
    case EDGE_ON_EDGE:
        put(q[0], p, i, 0);
        for (int x = 0; x < 3; x++)
            q[1][x] = 2 * q[0][x] - q[2][x];
        put(q[0], p, pick(random, 3), pick(random, 3));
        break;
    case ALONG_AN_EDGE:
        put(q[0], p, pick(random, 6), 0);
        put(q[1], p, pick(random, 6), 0);
        break;
    case EQUAL:
        memcpy(q, p, 9 * sizeof q[0][0]);
        break;
    default:
        make_thin(kind, p, q, random);
    }
}

static void take_corners(struct triangle *triangle, int64_t p[3][3],
                         struct random *random, double scale)
{
    static const int order[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                    {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    const int *from = order[random_bits(random) % 6];
    for (int k = 0; k < 3; k++)
        for (int x = 0; x < 3; x++)
            triangle->corner[k][x] = scale * (double)p[from[k]][x];
}

static bool check_pair(enum kind kind, struct random *random,
                       uint64_t *expanded)
{
    static const int64_t sizes[] = {1, 2, 3, 8, 50, 1 << 17};
    static const double scales[] = {1, 0x1p+200, 0x1p-200};
    const int64_t size = sizes[random_bits(random) % 6];
    int64_t p[3][3], q[3][3];
    for (int k = 0; k < 3; k++)
        for (int x = 0; x < 3; x++) {
            p[k][x] = 4 * pick(random, size);
            q[k][x] = 4 * pick(random, size);
        }
    make_kind(kind, p, q, random);
    const double scale = scales[random_bits(random) % 3];
    struct triangle one, other;
    take_corners(&one, p, random, scale);
    take_corners(&other, q, random, scale);
    const bool meet = plainly_meet(p, q);
    CHECK_INT(meet, triangles_meet(&one, &other, expanded), "%s",
              kind_name[kind]);
    CHECK_INT(meet, triangles_meet(&other, &one, expanded),
              "%s, swapped", kind_name[kind]);
    return meet;
}

void triangles_at_rest(void)
{
    const uint32_t n = pair_count(10000);
    struct random random = {1303};
    test_seed(1303);
    for (enum kind kind = 0; kind < KINDS; kind++) {
        uint64_t meet = 0, expanded = 0;
        for (uint32_t i = 0; i < n; i++)
            meet += check_pair(kind, &random, &expanded);
        const bool always = kind == AT_A_VERTEX || kind == EQUAL ||
                            kind == VERTEX_ON_FACE ||
                            kind == EDGE_ON_EDGE;
        CHECK(meet > n / 100, "%s: %llu meet", kind_name[kind],
              (unsigned long long)meet);
        CHECK(always ? meet == n : meet < n - n / 100, "%s: %llu meet",
              kind_name[kind], (unsigned long long)meet);
        CHECK(expanded > 0, "%s: no expansions", kind_name[kind]);
    }
}
