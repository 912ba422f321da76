// The narrow phase: orientations against 128-bit integers; triangles at
// rest against Caratheodory's theorem in integers, every degenerate
// kind among them; events in continuous time against contacts that were
// planned, and against triangles at rest at 1025 times of the step.
// CONTACT_PAIRS=1000000 takes so many pairs of each kind.
#include "narrow.h"
#include "ch13-contact/events.h"
#include "ch13-contact/triangle_pair.h"
#include "common/random.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

__extension__ typedef __int128 wide;

static uint32_t pair_count(uint32_t usual)
{
    const char *wanted = getenv("CONTACT_PAIRS");
    return at_most("MOST_CASES",
                   wanted ? (uint32_t)atoi(wanted) : usual);
}

// From -most to most.
static int64_t pick(struct random *random, int64_t most)
{
    return (int64_t)(random_bits(random) % (2 * most + 1)) - most;
}

static int sign_of(wide x)
{
    return (x > 0) - (x < 0);
}

// ---- orientations
// ----------------------------------------------------
void ranges_are_checked(void)
{
    const double good[] = {0, -0.0, 1, -1, 0x1p-280, -0x1p+280};
    const double bad[] = {0x1p-281, -0x1p+281, NAN, INFINITY, 5e-324};
    CHECK(exact_range(good, 6), "good coordinates");
    for (int k = 0; k < 5; k++)
        CHECK(!exact_range(&bad[k], 1), "bad coordinate %d", k);
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

void nearly_flat_sides_are_exact(void)
{
    const uint32_t n = pair_count(20000);
    struct random random = {1302};
    test_seed(1302);
    uint64_t expanded[2] = {0};
    for (uint32_t i = 0; i < n; i++) {
        int64_t p[4][3];
        if (i % 2)
            nearly_flat(p, &random);
        else
            flat_and_steep(p, &random);
        const double scale = i % 3 == 0   ? 1
                             : i % 3 == 1 ? 0x1p+200
                                          : 0x1p-200;
        check_orientations(p, scale, &expanded[i % 2]);
    }
    for (int kind = 0; kind < 2; kind++)
        CHECK(expanded[kind] > 4 * n, "only %llu needed expansions",
              (unsigned long long)expanded[kind]);
}

// ---- triangles at rest
// ----------------------------------------------- Two convex bodies
// meet if the origin is in the hull of the differences of their
// corners; then it is in a simplex of some of them that is not flat
// (Caratheodory 1907).
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
    case EQUAL:
        memcpy(q, p, 9 * sizeof q[0][0]);
        break;
    default:
        break;
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

// ---- events
// ----------------------------------------------------------
// Coordinates are multiples of 2^-20 or coarser, times of 2^-10, so
// that places at such times are exact.
enum { TIMES = 1024 };
static const double TOLERANCE = 0x1p-16;

static void place_at(const struct moving *node, double time,
                     double place[3])
{
    for (int x = 0; x < 3; x++)
        place[x] =
            node->begin[x] + time * (node->end[x] - node->begin[x]);
}

// At the time of the event the two are as near as was promised, and its
// point is there; weights are weights.
static void check_event(const struct event *event,
                        const struct moving node[4], double tolerance,
                        const char *what)
{
    const int of_first = event->kind == NODE_FACE ? 1 : 2;
    double apart[3] = {0}, off[3], sum[2] = {0}, gap2 = 0, off2 = 0;
    memcpy(off, event->point, sizeof off);
    for (int k = 0; k < 4; k++) {
        double place[3];
        place_at(&node[k], event->time, place);
        CHECK(event->weight[k] > -1e-12, "%s: weight %d", what, k);
        sum[k >= of_first] += event->weight[k];
        for (int x = 0; x < 3; x++) {
            const double part = event->weight[k] * place[x];
            apart[x] += k < of_first ? part : -part;
            off[x] -= k < of_first ? part : 0;
        }
    }
    for (int x = 0; x < 3; x++) {
        gap2 += apart[x] * apart[x];
        off2 += off[x] * off[x];
    }
    CHECK(gap2 <= tolerance * tolerance, "%s: %g apart", what,
          sqrt(gap2));
    CHECK(off2 <= 1e-20, "%s: the point is %g off", what, sqrt(off2));
    CHECK_NEAR(1, sum[0], 1e-12, "%s: weights of the first", what);
    CHECK_NEAR(1, sum[1], 1e-12, "%s: weights of the second", what);
    CHECK(event->time >= 0 && event->time <= 1, "%s: time", what);
}

static bool meets(enum contact kind, const struct moving node[4],
                  double tolerance, struct event *event,
                  struct event_counts *counts)
{
    return kind == NODE_FACE
               ? node_meets_face(node, node + 1, tolerance, event,
                                 counts)
               : edge_meets_edge(node, node + 2, tolerance, event,
                                 counts);
}

// Four nodes with contact planned at a time, at weights of quarters, at
// a corner or an edge as well. How they move:
enum plan {
    FREE,
    SLOW,
    STILL,
    FLAT,     // all in a plane
    PARALLEL, // along one line, all together but the first of two
    THIN,     // on a line, or at a point
    PLANS
};

static double part(struct random *random, double unit)
{
    return unit * pick(random, 1 << 12);
}

static void plan_nodes(enum plan plan, struct moving node[4],
                       struct random *random)
{
    for (int k = 0; k < 4; k++)
        for (int x = 0; x < 3; x++) {
            double *begin = node[k].begin, *end = node[k].end;
            begin[x] = part(random, 0x1p-12);
            end[x] = begin[x] +
                     part(random, plan == SLOW ? 0x1p-20 : 0x1p-12);
            if (plan == STILL)
                end[x] = begin[x];
            if (plan == FLAT && x == 2)
                begin[x] = end[x] = 0;
            if (plan == PARALLEL && x > 0)
                begin[x] = end[x] = k < 1 ? 0x1p-3 : 0;
            if (plan == THIN && k == 3)
                for (int s = 0; s < 3; s++) {
                    begin[s] = node[2].begin[s];
                    end[s] = node[2].end[s];
                }
        }
}

// Moves the first node so that there is contact at the time.
static void plan_contact(enum contact kind, struct moving node[4],
                         double time, struct random *random)
{
    const int i = random_bits(random) % 5;
    const int j = random_bits(random) % (5 - i);
    const double of_face[4] = {-1, (4 - i - j) / 4., i / 4., j / 4.};
    // The first edge is met at its first node, or half way.
    const double share = i % 2 ? 1 : 0.5;
    const double of_edge[4] = {-share, share - 1, j / 4., 1 - j / 4.};
    const double *weight = kind == NODE_FACE ? of_face : of_edge;
    for (int x = 0; x < 3; x++) {
        double off = 0;
        for (int k = 0; k < 4; k++) {
            double place[3];
            place_at(&node[k], time, place);
            off += weight[k] * place[x];
        }
        node[0].begin[x] += off / -weight[0];
        node[0].end[x] += off / -weight[0];
    }
}

void planned_contacts_are_found(void)
{
    const uint32_t n = pair_count(4000);
    struct random random = {1304};
    test_seed(1304);
    for (int kind = NODE_FACE; kind <= EDGE_EDGE; kind++)
        for (enum plan plan = 0; plan < PLANS; plan++) {
            struct event_counts counts = {0};
            uint64_t early = 0;
            for (uint32_t i = 0; i < n; i++) {
                struct moving node[4];
                struct event event = {0};
                const double time =
                    random_bits(&random) % (TIMES + 1) / (double)TIMES;
                const double tolerance =
                    ldexp(1, -8 - (int)(random_bits(&random) % 20));
                plan_nodes(plan, node, &random);
                plan_contact(kind, node, time, &random);
                if (!CHECK(
                        meets(kind, node, tolerance, &event, &counts),
                        "kind %d plan %d: contact %u", kind, plan, i))
                    continue;
                CHECK(event.time <= time,
                      "kind %d plan %d: at %g, not %g", kind, plan,
                      event.time, time);
                CHECK_INT(kind, event.kind, "kind");
                early += event.time < time - 0.01;
                check_event(&event, node, tolerance, "planned");
            }
            CHECK_INT(n, counts.tests, "tests");
            CHECK(counts.pieces < 200 * (uint64_t)n, "%llu pieces",
                  (unsigned long long)counts.pieces);
            CHECK(plan > SLOW || early < n / 2, "%llu too early",
                  (unsigned long long)early);
        }
}

// ---- against triangles at rest
// ---------------------------------------
static struct triangle triangle_at(const struct moving_triangle *p,
                                   double time)
{
    struct triangle at;
    for (int k = 0; k < 3; k++)
        place_at(&p->corner[k], time, at.corner[k]);
    return at;
}

// The first of 1025 times at which two triangles meet, 2 if none.
static double first_meeting(const struct moving_triangle *p,
                            const struct moving_triangle *q)
{
    for (int k = 0; k <= TIMES; k++) {
        const double time = k / (double)TIMES;
        const struct triangle a = triangle_at(p, time);
        const struct triangle b = triangle_at(q, time);
        if (triangles_meet(&a, &b, NULL))
            return time;
    }
    return 2;
}

static double to_grid(double x)
{
    return rint(x * 0x1p20) * 0x1p-20;
}

// Turns around the axis through the middle by an angle, and shifts.
static void move_rigidly(struct moving_triangle *p, double angle,
                         const double shift[3])
{
    double middle[3] = {0};
    for (int k = 0; k < 3; k++)
        for (int x = 0; x < 3; x++)
            middle[x] += p->corner[k].begin[x] / 3;
    for (int k = 0; k < 3; k++) {
        const double *from = p->corner[k].begin;
        double *to = p->corner[k].end;
        const double x = from[0] - middle[0], y = from[1] - middle[1];
        const double c = cos(angle), s = sin(angle);
        to[0] = to_grid(middle[0] + c * x - s * y + shift[0]);
        to[1] = to_grid(middle[1] + s * x + c * y + shift[1]);
        to[2] = to_grid(from[2] + shift[2]);
    }
}

// Kind 0: any motion; 1: rigid; 2: rigid and coarse, where touching is
// common; 3: flat; 4: a pair at rest; 5: small triangles, fast.
enum { SCENES = 6 };
static void make_scene(int kind, struct moving_triangle *p,
                       uint32_t number, struct random *random)
{
    const int most = kind == 2 ? 2 : 1 << 12;
    const double unit = kind == 2 ? 0.5 : 0x1p-12;
    double shift[3];
    for (int x = 0; x < 3; x++) {
        shift[x] = unit * pick(random, most);
        double middle = kind == 5 ? unit * pick(random, most / 4) : 0;
        for (int k = 0; k < 3; k++) {
            double *begin = p->corner[k].begin, *end = p->corner[k].end;
            begin[x] = middle + (kind == 5 ? 0.125 : 1) * unit *
                                    pick(random, most);
            end[x] = kind == 4 ? begin[x]
                               : begin[x] + unit * pick(random, most);
            if (kind == 3 && x == 2)
                begin[x] = end[x] = shift[x] = 0;
            p->node[k] = number + k;
        }
    }
    if (kind == 1 || kind == 5)
        move_rigidly(p, unit * pick(random, most), shift);
    if (kind == 2)
        move_rigidly(p, 0, shift);
}

static void check_events(const struct moving_triangle *p,
                         const struct moving_triangle *q,
                         const struct event *event, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        struct moving node[4];
        for (int k = 0; k < 4; k++) {
            const uint32_t number = event[i].node[k];
            node[k] =
                number < 3 ? p->corner[number] : q->corner[number - 3];
        }
        check_event(&event[i], node, TOLERANCE, "scene");
    }
}

void sampled_contacts_are_found(void)
{
    const uint32_t n = pair_count(600);
    struct random random = {1305};
    test_seed(1305);
    for (int kind = 0; kind < SCENES; kind++) {
        uint64_t found = 0;
        for (uint32_t i = 0; i < n; i++) {
            struct moving_triangle p, q;
            struct event event[MAX_EVENTS];
            make_scene(kind, &p, 0, &random);
            make_scene(kind, &q, 3, &random);
            const double meeting = first_meeting(&p, &q);
            const size_t events =
                triangle_events(&p, &q, TOLERANCE, event, NULL);
            check_events(&p, &q, event, events);
            if (meeting == 0 || meeting > 1)
                continue; // an event is no mistake
            double first = 2;
            for (size_t k = 0; k < events; k++)
                first = fmin(first, event[k].time);
            CHECK(first <= meeting, "scene %d: pair %u at %g, not %g",
                  kind, i, first, meeting);
            found++;
        }
        CHECK(kind == 4 || found > n / 50, "scene %d: %llu contacts",
              kind, (unsigned long long)found);
    }
}

// ---- what is no contact
// ---------------------------------------------- On two sides of a
// plane that turns and moves, a little more than the tolerance apart,
// and otherwise anywhere.
void what_stays_apart_has_no_event(void)
{
    const uint32_t n = pair_count(4000);
    struct random random = {1306};
    test_seed(1306);
    uint64_t searched = 0;
    for (uint32_t i = 0; i < n; i++) {
        const enum contact kind = i % 2;
        const int of_first = kind == NODE_FACE ? 1 : 2;
        const double tolerance = ldexp(1, -4 - (int)(i % 17));
        double axis[3], length2 = 0, shift[3];
        for (int x = 0; x < 3; x++) {
            axis[x] = random_normal(&random);
            length2 += axis[x] * axis[x];
            shift[x] = random_normal(&random);
        }
        struct moving node[4];
        for (int k = 0; k < 4; k++)
            for (int end = 0; end < 2; end++) {
                double *v = end ? node[k].end : node[k].begin;
                double side = 0;
                for (int x = 0; x < 3; x++) {
                    v[x] = random_normal(&random);
                    side += v[x] * axis[x];
                }
                const double wanted =
                    (k < of_first ? 0.502 : -0.502) * tolerance *
                    (random_bits(&random) % 4 ? 1 : 1000);
                for (int x = 0; x < 3; x++)
                    v[x] += axis[x] / sqrt(length2) *
                                (wanted - side / sqrt(length2)) +
                            end * shift[x];
            }
        struct event event;
        struct event_counts counts = {0};
        CHECK(!meets(kind, node, tolerance, &event, &counts),
              "kind %d: %u", kind, i);
        searched += counts.pieces > 0;
    }
    CHECK(searched > n / 10, "only %llu searched",
          (unsigned long long)searched);
}

void a_bullet_hits_a_sheet(void)
{
    static const double speeds[] = {1, 100, 1e6, 1e9};
    for (int k = 0; k < 4; k++) {
        const double z = speeds[k];
        const double tolerance = fmax(1e-6, 0x1p-38 * z);
        struct moving_triangle sheet = {{{{0, 0, 0}, {0, 0, 0}},
                                         {{1, 0, 0}, {1, 0, 0}},
                                         {{0, 1, 0}, {0, 1, 0}}},
                                        {0, 1, 2}};
        struct moving_triangle bullet = {
            {{{.25, .25, z}, {.25, .25, -3 * z}},
             {{.26, .25, z}, {.26, .25, -3 * z}},
             {{.25, .26, z + .01}, {.25, .26, -3 * z + .01}}},
            {3, 4, 5}};
        struct event event[MAX_EVENTS];
        const size_t n =
            triangle_events(&sheet, &bullet, tolerance, event, NULL);
        CHECK(n >= 3, "speed %g: %zu events", z, n);
        double first = 1;
        for (size_t i = 0; i < n; i++)
            first = fmin(first, event[i].time);
        CHECK(first <= 0.25 && first >= 0.25 - 2 * tolerance / z,
              "speed %g: at %.17g", z, first);
    }
}

void what_does_not_move(void)
{
    struct moving_triangle p = {{{{0, 0, 0}, {0, 0, 0}},
                                 {{4, 0, 0}, {4, 0, 0}},
                                 {{0, 4, 0}, {0, 4, 0}}},
                                {0, 1, 2}};
    for (int above = 0; above < 3; above++) {
        // On the face, nearer than the tolerance, further.
        const double z = above * 0.75e-6;
        struct moving_triangle q = {{{{1, 1, z}, {1, 1, z}},
                                     {{1, 1, 5}, {1, 1, 5}},
                                     {{3, 3, 5}, {3, 3, 5}}},
                                    {3, 4, 5}};
        struct event event[MAX_EVENTS] = {0};
        struct event_counts counts = {0};
        const size_t n = triangle_events(&p, &q, 1e-6, event, &counts);
        CHECK_INT(15, counts.tests, "tests");
        CHECK_INT(above == 0, n, "events at height %g", z);
        if (n == 0)
            continue;
        CHECK_DOUBLE(0, event[0].time, "time");
        CHECK_INT(NODE_FACE, event[0].kind, "kind");
        CHECK_INT(3, event[0].node[0], "node");
        for (uint32_t k = 0; k < 3; k++)
            CHECK_INT(k, event[0].node[1 + k], "face");
        CHECK_NEAR(1, event[0].point[0], 1e-9, "x");
        CHECK_NEAR(1, event[0].point[1], 1e-9, "y");
        CHECK_NEAR(0.25, event[0].weight[2], 1e-9, "weight");
    }
}

// Two triangles on one edge are no contact. Folded like a book until
// the free node of one goes through the other, they are, at that node.
void shared_nodes_are_no_contact(void)
{
    struct moving_triangle p = {{{{0, 0, 0}, {0, 0, 0}},
                                 {{4, 0, 0}, {4, 0, 0}},
                                 {{1, 4, 0}, {1, 4, 0}}},
                                {0, 1, 2}};
    struct moving_triangle q = {{{{4, 0, 0}, {4, 0, 0}},
                                 {{0, 0, 0}, {0, 0, 0}},
                                 {{1, -2, 0}, {1, -2, 0}}},
                                {1, 0, 3}};
    struct event event[MAX_EVENTS] = {0};
    struct event_counts counts = {0};
    CHECK_INT(0, triangle_events(&p, &q, 1e-6, event, &counts),
              "at rest");
    CHECK_INT(4, counts.tests, "one node each, two pairs of edges");
    const double begin[3] = {1, 2, 3}, end[3] = {1, 2, -1};
    memcpy(q.corner[2].begin, begin, sizeof begin);
    memcpy(q.corner[2].end, end, sizeof end);
    if (CHECK_INT(1, triangle_events(&p, &q, 1e-6, event, NULL),
                  "folded")) {
        CHECK_NEAR(0.75, event[0].time, 1e-6, "time");
        CHECK_INT(3, event[0].node[0], "node");
    }
    CHECK_INT(0, triangle_events(&p, &p, 1e-6, event, NULL), "itself");
}

// Powers of two change no digit of what is found.
void scales_make_no_difference(void)
{
    const uint32_t n = pair_count(1000);
    struct random random = {1307};
    test_seed(1307);
    static const double scales[] = {0x1p+200, 0x1p-200};
    for (uint32_t i = 0; i < n; i++) {
        const enum contact kind = i % 2;
        struct moving node[4], scaled[4];
        plan_nodes(i % PLANS, node, &random);
        plan_contact(kind, node, 0.75, &random);
        const double scale = scales[random_bits(&random) % 2];
        for (int k = 0; k < 4; k++)
            for (int x = 0; x < 3; x++) {
                scaled[k].begin[x] = scale * node[k].begin[x];
                scaled[k].end[x] = scale * node[k].end[x];
            }
        struct event one = {0}, other = {0};
        CHECK(meets(kind, node, TOLERANCE, &one, NULL), "as it is");
        CHECK(meets(kind, scaled, scale * TOLERANCE, &other, NULL),
              "scaled");
        CHECK_DOUBLE(one.time, other.time, "time");
        for (int k = 0; k < 4; k++)
            CHECK_DOUBLE(one.weight[k], other.weight[k], "weight %d",
                         k);
    }
}
