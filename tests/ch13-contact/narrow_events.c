// Events in continuous time: against contacts that were planned, and
// against triangles at rest at 1025 times of the step.
#include "ch13-contact/events.h"
#include "ch13-contact/triangle_pair.h"
#include "common/min_max.h"
#include "narrow.h"
#include <math.h>
#include <string.h>

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

static bool meets(enum feature_kind kind, const struct moving node[4],
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
    TILTED,   // all in a plane in which products are rounded
    NEEDLE,   // nearly on a line, nearly parallel
    PLANS
};

static double part(struct random *random, double unit)
{
    return unit * pick(random, 1 << 12);
}

// In the plane 8 z = 3 x + 5 y.
static void tilt(struct moving node[4], struct random *random)
{
    for (int k = 0; k < 4; k++) {
        double *begin = node[k].begin, *end = node[k].end;
        for (int x = 0; x < 2; x++) {
            begin[x] = 0x1p-22 * pick(random, 1 << 22);
            end[x] = 0x1p-22 * pick(random, 1 << 22);
        }
        begin[2] = (3 * begin[0] + 5 * begin[1]) / 8;
        end[2] = (3 * end[0] + 5 * end[1]) / 8;
    }
}

// The last node goes along with the one before, nearly: face or edge
// are narrow, edges nearly parallel.
static void narrow(struct moving node[4], struct random *random)
{
    const double width =
        ldexp(1, -20 - (int)(random_bits(random) % 12));
    for (int x = 0; x < 3; x++) {
        const double off = width * pick(random, 2);
        const double a = node[1].begin[x], b = node[2].begin[x];
        const double way = node[1].end[x] - a;
        node[3].begin[x] = a + 0.75 * (b - a) + off;
        node[2].end[x] = b + way;
        node[3].end[x] = node[3].begin[x] + way;
        node[0].begin[x] = 2 * a - b;
        node[0].end[x] = node[0].begin[x] + part(random, 0x1p-14);
    }
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
    if (plan == TILTED)
        tilt(node, random);
    if (plan == NEEDLE)
        narrow(node, random);
}

// Moves the first node so that there is contact at the time.
static void plan_contact(enum feature_kind kind, struct moving node[4],
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
                    ldexp(1, -8 - (int)(random_bits(&random) % 24));
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
            // On average; of few, one may be hard.
            CHECK(counts.pieces < (plan == NEEDLE ? 1000 : 100) *
                                      (uint64_t)MAX(n, 1000),
                  "%llu pieces", (unsigned long long)counts.pieces);
            CHECK(plan > SLOW || early < n / 2 + 20, "%llu too early",
                  (unsigned long long)early);
        }
}

// ---- against triangles at rest ------------------------------------
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
    const int max = kind == 2 ? 2 : 1 << 12;
    const double unit = kind == 2 ? 0.5 : 0x1p-12;
    double shift[3];
    for (int x = 0; x < 3; x++) {
        shift[x] = unit * pick(random, max);
        double middle = kind == 5 ? unit * pick(random, max / 4) : 0;
        for (int k = 0; k < 3; k++) {
            double *begin = p->corner[k].begin, *end = p->corner[k].end;
            begin[x] = middle + (kind == 5 ? 0.125 : 1) * unit *
                                    pick(random, max);
            end[x] = kind == 4 ? begin[x]
                               : begin[x] + unit * pick(random, max);
            if (kind == 3 && x == 2)
                begin[x] = end[x] = shift[x] = 0;
            p->node[k] = number + k;
        }
    }
    if (kind == 1 || kind == 5)
        move_rigidly(p, unit * pick(random, max), shift);
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
            const size_t events = triangle_events(
                &p, &q, TOLERANCE, event, &(struct event_counts){0});
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

// ---- what is no contact -------------------------------------------

// Nodes on two sides of a plane, half that width away or a thousand
// times further, and otherwise anywhere.
static void part_nodes(struct moving node[4], int of_first,
                       double width, struct random *random)
{
    double axis[3], shift[3];
    for (int x = 0; x < 3; x++) {
        axis[x] = random_normal(random);
        shift[x] = random_normal(random);
    }
    const double length =
        sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    for (int k = 0; k < 4; k++)
        for (int end = 0; end < 2; end++) {
            double *v = end ? node[k].end : node[k].begin;
            double side = 0;
            for (int x = 0; x < 3; x++) {
                v[x] = random_normal(random);
                side += v[x] * axis[x] / length;
            }
            const double wanted = (k < of_first ? 0.5 : -0.5) * width *
                                  (random_bits(random) % 4 ? 1 : 1000);
            for (int x = 0; x < 3; x++)
                v[x] +=
                    axis[x] / length * (wanted - side) + end * shift[x];
        }
}

// A little more than the tolerance apart.
void what_stays_apart_has_no_event(void)
{
    const uint32_t n = pair_count(4000);
    struct random random = {1306};
    test_seed(1306);
    struct event_counts counts = {0};
    for (uint32_t i = 0; i < n; i++) {
        const enum feature_kind kind = i % 2;
        const double tolerance = ldexp(1, -4 - (int)(i % 17));
        struct moving node[4];
        struct event event;
        part_nodes(node, kind == NODE_FACE ? 1 : 2, 1.004 * tolerance,
                   &random);
        CHECK(!meets(kind, node, tolerance, &event, &counts),
              "kind %d: %u", kind, i);
    }
    const uint64_t searched =
        counts.tests - counts.by_boxes - counts.by_signs;
    CHECK_INT(n, counts.tests, "tests");
    CHECK(counts.by_boxes > n / 50 && counts.by_signs > n / 50 &&
              searched > n / 50,
          "only %llu searched", (unsigned long long)searched);
}

void a_bullet_hits_a_sheet(void)
{
    static const double speeds[] = {1, 100, 1e6, 1e9};
    for (int k = 0; k < 4; k++) {
        const double z = speeds[k];
        const double tolerance = 1e-6;
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
            triangle_events(&sheet, &bullet, tolerance, event,
                            &(struct event_counts){0});
        CHECK(n >= 3, "speed %g: %zu events", z, n);
        double first = 1;
        for (size_t i = 0; i < n; i++)
            first = fmin(first, event[i].time);
        CHECK(first <= 0.25 &&
                  first >= 0.25 - fmax(tolerance / z, 0x1p-38),
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
    if (CHECK_INT(1,
                  triangle_events(&p, &q, 1e-6, event,
                                  &(struct event_counts){0}),
                  "folded")) {
        CHECK_NEAR(0.75, event[0].time, 1e-6, "time");
        CHECK_INT(3, event[0].node[0], "node");
    }
    CHECK_INT(
        0,
        triangle_events(&p, &p, 1e-6, event, &(struct event_counts){0}),
        "itself");
}

// Powers of two change no digit of what is found.
void scales_make_no_difference(void)
{
    const uint32_t n = pair_count(1000);
    struct random random = {1307};
    test_seed(1307);
    static const double scales[] = {0x1p+200, 0x1p-200};
    for (uint32_t i = 0; i < n; i++) {
        const enum feature_kind kind = i % 2;
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
        CHECK(meets(kind, node, TOLERANCE, &one,
                    &(struct event_counts){0}),
              "as it is");
        CHECK(meets(kind, scaled, scale * TOLERANCE, &other,
                    &(struct event_counts){0}),
              "scaled");
        CHECK_DOUBLE(one.time, other.time, "time");
        for (int k = 0; k < 4; k++)
            CHECK_DOUBLE(one.weight[k], other.weight[k], "weight %d",
                         k);
    }
}
