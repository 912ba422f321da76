// Tests of the filter: answers, also where single precision finds
// another point, and which are computed again.
#include "common/geometry.h"
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <string.h>

enum { MOST = 24, QUESTIONS = 300 };

// What single precision may be wrong by is a multiple of this.
static const double unit = 0x1p-24;

static struct question {
    uint32_t n;
    double ax, ay, x[MOST], y[MOST];
    float single_x[MOST], single_y[MOST];
    uint32_t index[MOST];
} * questions;

static uint32_t asking;

// What the student's process leaves behind.
static struct found *found;
static struct notes {
    uint32_t asked[MOST];
    bool bad_place;
    uint32_t place;
} * notes;

static double right2(const struct question *q, uint32_t place)
{
    return distance2(q->x[place] - q->ax, q->y[place] - q->ay);
}

double exact(uint32_t place)
{
    const struct question *q = &questions[asking];
    notes[asking].place = place;
    notes[asking].bad_place = place >= q->n;
    if (place >= q->n)
        kit_leave();
    notes[asking].asked[place]++;
    return right2(q, place);
}

// ---- questions -----------------------------------------------------

static void add(struct question *q, double x, double y)
{
    q->x[q->n] = x;
    q->y[q->n] = y;
    q->n++;
}

static void swap(double *a, double *b)
{
    double c = *a;
    *a = *b;
    *b = c;
}

// Any places, and indices that are in no order.
static void finish(struct question *q, struct random *random)
{
    for (uint32_t s = 0; s < q->n; s++)
        q->index[s] = s;
    for (uint32_t s = q->n; s > 1; s--) {
        uint32_t other = random_bits(random) % s;
        swap(&q->x[s - 1], &q->x[other]);
        swap(&q->y[s - 1], &q->y[other]);
        other = random_bits(random) % s;
        uint32_t index = q->index[s - 1];
        q->index[s - 1] = q->index[other];
        q->index[other] = index;
    }
    for (uint32_t s = 0; s < q->n; s++) {
        q->single_x[s] = (float)q->x[s];
        q->single_y[s] = (float)q->y[s];
    }
}

// In the middle of a block, somewhere in the unit square.
static void ask_in_block(struct question *q, struct random *random)
{
    double side = 0.03, left = (1 - side) * random_uniform(random),
           low = (1 - side) * random_uniform(random);
    q->ax = left + side * (1 + random_uniform(random)) / 3;
    q->ay = low + side * (1 + random_uniform(random)) / 3;
    for (int k = 0; k < 12; k++)
        add(q, left + side * random_uniform(random),
            low + side * random_uniform(random));
}

// Around a query, at distances from radius on, so far apart.
static void ask_in_ring(struct question *q, double radius, double apart,
                        struct random *random)
{
    q->ax = 0.2 + 0.6 * random_uniform(random);
    q->ay = 0.2 + 0.6 * random_uniform(random);
    for (int k = 0; k < 16; k++) {
        double dx, dy, r = radius + apart * k;
        random_direction(random, &dx, &dy);
        add(q, q->ax + r * dx, q->ay + r * dy);
    }
}

// Two on a diagonal, on either side, all coordinates as badly rounded
// as can be: the nearer one is rounded away, the other one closer.
static void ask_on_diagonal(struct question *q, double radius,
                            struct random *random)
{
    double sign = random_bits(random) % 2 ? 1 : -1;
    double step = sign * unit, wrong = 0.48 * step;
    double ax = 0.65 + 0.15 * random_uniform(random);
    double ay = 0.65 + 0.15 * random_uniform(random);
    double k = floor(radius / unit);
    ax = floor(ax / unit) * unit;
    ay = floor(ay / unit) * unit;
    q->ax = ax + wrong;
    q->ay = ay + wrong;
    add(q, ax + (k + 3) * step - wrong, ay + k * step - wrong);
    add(q, ax - k * step - wrong, ay - k * step - wrong);
    add(q, ax - 0.1 * sign, ay + 0.1 * sign);
}

// On a lattice, with as many at the same distance as there can be.
static void ask_on_lattice(struct question *q, struct random *random)
{
    double side = 1.0 / 64;
    q->ax = side * (16 + random_bits(random) % 32);
    q->ay = side * (16 + random_bits(random) % 32);
    double off = random_bits(random) % 2 ? side / 2 : side;
    for (int column = -1; column <= 2; column++)
        for (int row = -1; row <= 2; row++) {
            double dx = column * side - side + off;
            double dy = row * side - side + off;
            if (dx != 0 || dy != 0)
                add(q, q->ax + dx, q->ay + dy);
        }
}

enum kind { BLOCK, RING, RUNGS, DIAGONAL, LATTICE };
static const char *const names[] = {
    "random points", "distances that hardly differ",
    "distances in small steps", "rounded as badly as can be",
    "points on a lattice"};

static void prepare(enum kind kind, uint64_t seed)
{
    struct random random = {seed};
    questions = kit_input("questions", QUESTIONS, sizeof *questions);
    for (uint32_t k = 0; k < QUESTIONS; k++) {
        struct question *q = &questions[k];
        double radius = 0.11 * exp(-7 * random_uniform(&random));
        q->n = 0;
        if (kind == BLOCK)
            ask_in_block(q, &random);
        if (kind == RING)
            ask_in_ring(q, radius, 0x1p-28, &random);
        if (kind == RUNGS)
            ask_in_ring(q, radius, 0x1p-22, &random);
        if (kind == DIAGONAL)
            ask_on_diagonal(q, radius, &random);
        if (kind == LATTICE)
            ask_on_lattice(q, &random);
        finish(q, &random);
    }
    kit_given("%s", names[kind]);
}

// ---- checks --------------------------------------------------------

static uint32_t winner(const struct question *q)
{
    uint32_t best = 0;
    for (uint32_t s = 1; s < q->n; s++) {
        double d2 = right2(q, s), best2 = right2(q, best);
        if (d2 < best2 || (d2 == best2 && q->index[s] < q->index[best]))
            best = s;
    }
    return best;
}

static float single2(const struct question *q, uint32_t place)
{
    float dx = q->single_x[place] - (float)q->ax;
    float dy = q->single_y[place] - (float)q->ay;
    return dx * dx + dy * dy;
}

// The distance in single precision, and the smallest of all.
static double single(const struct question *q, uint32_t place)
{
    return sqrt(single2(q, place));
}

static double least_single(const struct question *q)
{
    double least = INFINITY;
    for (uint32_t s = 0; s < q->n; s++)
        least = fmin(least, single(q, s));
    return least;
}

static uint32_t place_of(const struct question *q, uint32_t index)
{
    uint32_t place = 0;
    while (place < q->n && q->index[place] != index)
        place++;
    return place;
}

static const char *tell(const struct question *q, uint32_t place)
{
    return kit_text("point %u at place %u, distance %.11g, %.11g in "
                    "single precision",
                    q->index[place], place, sqrt(right2(q, place)),
                    single(q, place));
}

static const char *tell_asking(const struct question *q)
{
    return kit_text("at (%.9g, %.9g), rounded to (%.9g, %.9g)", q->ax,
                    q->ay, (float)q->ax, (float)q->ay);
}

static const char *wrong_cause(const struct question *q, uint32_t right,
                               const struct notes *note,
                               struct found answer)
{
    uint32_t place = place_of(q, answer.nearest);
    if (place < q->n && answer.nearest2 != right2(q, place) &&
        (float)answer.nearest2 == single2(q, place))
        return "This is the distance in single precision. The answer "
               "is what exact() says.";
    if (place < q->n && answer.nearest2 != right2(q, place))
        return "This is not the distance of that point.";
    if (place < q->n && right2(q, place) == right2(q, right))
        return "These tie, and the other one has the lower index.";
    if (note->asked[right] > 0)
        return "It was computed again, and then forgotten.";
    return kit_text("It was not computed again, because in single "
                    "precision another one is nearer, by %.2f of "
                    "2^-24. Both may be wrong, in opposite directions, "
                    "and at any distance: what was rounded are the "
                    "coordinates.",
                    (single(q, right) - least_single(q)) / unit);
}

static void ask_all(float *scratch)
{
    for (asking = 0; asking < QUESTIONS; asking++) {
        const struct question *q = &questions[asking];
        struct candidates candidates = {q->n, q->single_x, q->single_y,
                                        q->index};
        found[asking] = STUDENT(filter)(&candidates, (float)q->ax,
                                        (float)q->ay, scratch);
    }
}

static void check_answers(void)
{
    found = kit_output("answers", QUESTIONS, sizeof *found);
    notes = kit_output("the notes", QUESTIONS, sizeof *notes);
    memset(notes, 0, QUESTIONS * sizeof *notes);
    float *scratch = kit_output("scratch", MOST, sizeof *scratch);
    CALL(ask_all(scratch));
    for (uint32_t k = 0; k < QUESTIONS; k++) {
        const struct question *q = &questions[k];
        uint32_t right = winner(q), place;
        if (notes[k].bad_place)
            WRONG(.where = tell_asking(q),
                  .expected = kit_text("places below %u", q->n),
                  .found = kit_text("exact(%u)", notes[k].place),
                  .cause = "exact() takes a place, not an index.");
        if (found[k].nearest == q->index[right] &&
            found[k].nearest2 == right2(q, right))
            continue;
        place = place_of(q, found[k].nearest);
        WRONG(.where = tell_asking(q), .expected = tell(q, right),
              .found =
                  place == q->n
                      ? "none"
                      : kit_text("%s; answered %.11g", tell(q, place),
                                 sqrt(found[k].nearest2)),
              .cause = wrong_cause(q, right, &notes[k], found[k]));
    }
}

static const char *look_cause(const struct question *q, uint32_t place,
                              const struct notes *note)
{
    uint32_t asked = 0;
    double least = least_single(q);
    for (uint32_t s = 0; s < q->n; s++)
        asked += note->asked[s] > 0;
    if (asked == q->n)
        return "All were computed. What is clearly further away in "
               "single precision need not be.";
    if (single2(q, place) <= (least * least + 0x1p-21) * (1 + 0x1p-20))
        return "The bound is one for distances. Those of squares "
               "differ by much less: take the root of the smallest, "
               "add, and square again.";
    return "Are all compared with the smallest of all, or with "
           "the smallest so far? Find it first.";
}

static void check_looks(void)
{
    check_answers();
    for (uint32_t k = 0; k < QUESTIONS; k++) {
        const struct question *q = &questions[k];
        for (uint32_t s = 0; s < q->n; s++) {
            if (notes[k].asked[s] > 1)
                WRONG(.where = tell_asking(q), .expected = tell(q, s),
                      .found = kit_text("computed %u times",
                                        notes[k].asked[s]),
                      .cause = "Once is enough.");
            if (notes[k].asked[s] == 0 ||
                single(q, s) <= least_single(q) + 0x1p-21)
                continue;
            WRONG(.where = tell_asking(q),
                  .expected = kit_text("none beyond %.11g + 2^-21 "
                                       "computed again",
                                       least_single(q)),
                  .found = tell(q, s),
                  .cause = look_cause(q, s, &notes[k]));
        }
    }
}

// A program that computes all of them again has not filtered anything,
// however right its answers are.
static void check_filters(uint64_t seed)
{
    prepare(BLOCK, seed);
    check_answers();
    uint64_t candidates = 0, computed = 0;
    for (uint32_t k = 0; k < QUESTIONS; k++) {
        candidates += questions[k].n;
        for (uint32_t s = 0; s < questions[k].n; s++)
            computed += notes[k].asked[s];
    }
    if (2 * computed > candidates)
        WRONG(.expected = "less than half of the candidates computed "
                          "again",
              .found = kit_text("%ju of %ju", (uintmax_t)computed,
                                (uintmax_t)candidates),
              .cause = "These are random points, far apart. What is "
                       "clearly further away in single precision need "
                       "not be computed again.");
    kit_next_case();
}

// ---- tests ---------------------------------------------------------

static void random_points(uint64_t seed)
{
    prepare(BLOCK, seed);
    check_answers();
}

static void close_calls(uint64_t seed)
{
    check_filters(seed);
    prepare(RING, seed);
    check_answers();
}

static void worst(uint64_t seed)
{
    check_filters(seed);
    prepare(DIAGONAL, seed);
    check_answers();
}

static void ties(uint64_t seed)
{
    check_filters(seed);
    prepare(LATTICE, seed);
    check_answers();
}

static void looks(uint64_t seed)
{
    prepare(BLOCK, seed);
    check_looks();
    kit_next_case();
    prepare(RUNGS, seed);
    check_looks();
}

const struct kit_test kit_tests[] = {
    {"random", 1, "random points", random_points},
    {"close", 2, "filtered: distances that hardly differ", close_calls},
    {"worst", 2, "filtered: rounded as badly as can be", worst},
    {"ties", 2, "filtered: the lowest index of a tie", ties},
    {"looks", 3, "none is computed twice for nothing", looks},
    {0},
};
