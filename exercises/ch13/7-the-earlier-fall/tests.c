// Tests of the earlier fall: answers against the real numbers, told by
// sums in which nothing is rounded; and how often it is not sure.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

enum { MOST = 20000, PARTS = 12 };

struct trial {
    double floor;
    struct fall p, q;
};

static int count, scale; // numbers are multiples of 2^scale
static struct trial *trial;
static enum first *found;

static void begin_case(int trials, int to_scale)
{
    kit_next_case();
    count = trials;
    scale = to_scale;
    trial = kit_input("the falls", count, sizeof *trial);
    found = kit_output("the answers", count, sizeof *found);
}

// Adds a number to a sum of parts that do not overlap, from the least
// to the greatest, and loses nothing (Shewchuk, 1997).
static void add(double *part, int parts, double x)
{
    for (int k = 0; k < parts; k++) {
        const double sum = part[k] + x, in_sum = sum - part[k];
        part[k] = (part[k] - (sum - in_sum)) + (x - in_sum);
        x = sum;
    }
    part[parts] = x;
}

static void add_product(double *part, int parts, double a, double b)
{
    add(part, parts, fma(a, b, -(a * b)));
    add(part, parts + 1, a * b);
}

// The product for p less the product for q, rounded once, at the end:
// its sign is right. With the floor's square gone, six products remain.
static double difference(const struct trial *t)
{
    const double f = t->floor;
    const double product[PARTS / 2][2] = {
        {t->p.begin, f},  {-t->p.begin, t->q.end}, {f, t->q.end},
        {-t->q.begin, f}, {t->q.begin, t->p.end},  {-f, t->p.end}};
    double part[PARTS], sum = 0;
    for (int k = 0; k < PARTS / 2; k++)
        add_product(part, 2 * k, product[k][0], product[k][1]);
    for (int k = 0; k < PARTS; k++)
        sum += part[k];
    return sum;
}

static enum first truth(const struct trial *t)
{
    const double p_less_q = difference(t);
    return p_less_q == 0 ? BOTH : p_less_q < 0 ? FIRST_P : FIRST_Q;
}

static bool has_a_step(const struct trial *t)
{
    return t->p.begin > t->floor && t->floor > t->p.end &&
           t->q.begin > t->floor && t->floor > t->q.end;
}

// Random integers of so many bits, times 2^scale.
static double random_number(struct random *random, int bits)
{
    const uint64_t all = random_bits(random) >> (64 - bits);
    const double x = (double)all - ldexp(1, bits - 1);
    return ldexp(x, scale);
}

static struct fall random_fall(struct random *random, double floor,
                               int bits)
{
    for (;;) {
        const double a = random_number(random, bits);
        const double b = random_number(random, bits);
        const struct fall fall = {fmax(a, b), fmin(a, b)};
        if (fall.begin > floor && floor > fall.end)
            return fall;
    }
}

// The end of q at which it arrives later than p by about this share.
static void aim(struct trial *t, double share)
{
    const double depth = (t->q.begin - t->floor) *
                         (t->floor - t->p.end) /
                         (t->p.begin - t->floor) * (1 - share);
    t->q.end = ldexp(nearbyint(ldexp(t->floor - depth, -scale)), scale);
}

// p and q arrive at times that differ by about the share, or are as
// near as there are numbers if it is 0.
static void make_trial(struct random *random, struct trial *t,
                       double share)
{
    do {
        t->floor = random_number(random, 52) / 2;
        t->floor = ldexp(floor(ldexp(t->floor, -scale)), scale);
        t->p = random_fall(random, t->floor, 53);
        t->q = random_fall(random, t->floor, 53);
        aim(t, random_bits(random) % 2 ? share : -share);
        const int steps = share > 0 ? 0 : random_bits(random) % 5 - 2;
        t->q.end += ldexp(steps, scale);
    } while (!has_a_step(t) || fabs(t->q.end) > ldexp(1, 53 + scale));
}

static const char *name_of(enum first first)
{
    static const char *name[] = {"BOTH", "FIRST_P", "FIRST_Q",
                                 "NOT_SURE"};
    return first <= NOT_SURE ? name[first] : "none of the four";
}

static const char *text_of(const struct trial *t)
{
    return kit_text("floor %.17g, p from %.17g to %.17g, q from %.17g "
                    "to %.17g",
                    t->floor, t->p.begin, t->p.end, t->q.begin,
                    t->q.end);
}

static const char *cause_of(enum first is, enum first right)
{
    if (is > NOT_SURE)
        return "That is no answer.";
    if (right == BOTH || is == BOTH)
        return "Two results that are equal may have been rounded; only "
               "if nothing was rounded are they the same.";
    return "It is sure, and wrong. How many roundings are in each of "
           "the two numbers that are compared?";
}

// By which share of the earlier time the two times differ.
static double share_of(const struct trial *t)
{
    const double p_less_q = difference(t);
    const struct fall *first = p_less_q < 0 ? &t->p : &t->q;
    const struct fall *later = p_less_q < 0 ? &t->q : &t->p;
    return fabs(p_less_q) /
           ((first->begin - t->floor) * (later->begin - later->end));
}

// Runs all trials: none may be wrong. Returns one in which it was not
// sure though the times differ by more than this share, or NULL.
static const struct trial *ask(double share)
{
    CALL(for (int k = 0; k < count; k++) found[k] = STUDENT(earlier)(
             trial[k].floor, &trial[k].p, &trial[k].q));
    const struct trial *doubted = NULL;
    for (int k = 0; k < count; k++) {
        const enum first right = truth(&trial[k]);
        if (found[k] == NOT_SURE && share_of(&trial[k]) > share)
            doubted = &trial[k];
        else if (found[k] != NOT_SURE && found[k] != right)
            WRONG(.where = text_of(&trial[k]),
                  .expected =
                      kit_text("%s or NOT_SURE", name_of(right)),
                  .found = name_of(found[k]),
                  .cause = cause_of(found[k], right));
    }
    return doubted;
}

static void random_falls(struct random *random)
{
    for (int part = 0; part < 3; part++) {
        begin_case(MOST, -60 + 30 * part);
        for (int k = 0; k < count; k++)
            make_trial(random, &trial[k],
                       k % 2 ? 0 : ldexp(1, -(k % 54)));
        ask(0);
        int sure = 0;
        for (int k = 0; k < count; k++)
            sure += found[k] != NOT_SURE;
        if (sure == 0)
            WRONG(.expected = "an answer", .found = "NOT_SURE, always",
                  .cause = "Half of these pairs differ by far.");
    }
}

// From 1 to 1 + 2^-6, and an even number of units of 2^-52: a number
// that is half a unit more is rounded to it.
static double even_number(struct random *random)
{
    return 1 + ldexp((double)(random_bits(random) >> 19), -51);
}

// All six roundings conspire: each is of nearly half a unit, where the
// unit is largest, those of p down and those of q up. So p's product
// looks less by 6 roundings, that is 3 of the sum, and is greater.
static bool find_worst(struct random *random, struct trial *t)
{
    enum { ATTEMPTS = 2000 };
    const double half = 0x1p-53, nearly = half * 63 / 64;
    double a, b, c, d;
    do {
        a = even_number(random), b = even_number(random);
    } while (fma(a, b, -(a * b)) < nearly);
    for (int k = 0; k < ATTEMPTS; k++) {
        c = even_number(random);
        d = 1 + ldexp(1 + nearbyint(ldexp(a * b / c - 1, 51)), -51);
        t->floor = -half;
        t->p = (struct fall){a, -d};
        t->q = (struct fall){c - 2 * half, -b - 2 * half};
        if (fma(c, d, -(c * d)) <= -nearly &&
            c * d - a * b == 6 * half && difference(t) > 0)
            return true;
    }
    return false;
}

static void exchange(struct trial *t)
{
    const struct fall p = t->p;
    t->p = t->q;
    t->q = p;
}

// By a factor that is a power of two, which rounds nothing.
static void enlarge(struct trial *t, double factor)
{
    t->floor *= factor;
    t->p.begin *= factor, t->p.end *= factor;
    t->q.begin *= factor, t->q.end *= factor;
}

static void worst_falls(struct random *random)
{
    begin_case(1000, 0);
    for (int k = 0; k < count; k++) {
        while (!find_worst(random, &trial[k]))
            continue;
        enlarge(&trial[k], ldexp(1, k % 61 - 30));
        if (k % 2)
            exchange(&trial[k]);
    }
    ask(INFINITY);
}

// A floor so near to 0 that all four differences lose it: what is left
// are small integers, of which q's are some multiple of p's.
static void tiny_floors(struct random *random)
{
    begin_case(2000, 0);
    for (int k = 0; k < count; k++) {
        struct trial *t = &trial[k];
        const double times = 1 + (double)(random_bits(random) % 8);
        const double above = 1 + (double)(random_bits(random) % 1000);
        const double below = 1 + (double)(random_bits(random) % 1000);
        t->floor = ldexp(k % 2 ? 1 : -1, -70 - k % 31);
        t->p = (struct fall){above, -below};
        t->q = (struct fall){above * times, -below * times};
        if (k % 4 > 1)
            exchange(t);
    }
    ask(INFINITY);
}

static void is_true(uint64_t seed)
{
    struct random random = {seed};
    random_falls(&random);
    worst_falls(&random);
    tiny_floors(&random);
}

static void integers(uint64_t seed)
{
    struct random random = {seed};
    for (int bits = 3; bits <= 26; bits++) {
        begin_case(1000, 0);
        for (int k = 0; k < count; k++) {
            struct trial *t = &trial[k];
            do
                t->floor = random_number(&random, bits - 1);
            while (t->floor <= -ldexp(1, bits - 2));
            t->p = t->q = random_fall(&random, t->floor, bits);
            if (k % 3 > 0)
                t->q = random_fall(&random, t->floor, bits);
            if (k % 3 > 1) // twice as high, twice as deep
                t->q = (struct fall){
                    t->floor + (t->p.begin - t->floor) / 2,
                    t->floor - (t->floor - t->p.end) / 2};
            if (k % 3 > 1 && (floor(t->q.begin) != t->q.begin ||
                              floor(t->q.end) != t->q.end))
                t->q = t->p;
        }
        ask(0);
        for (int k = 0; k < count; k++)
            if (found[k] == NOT_SURE)
                WRONG(.where = text_of(&trial[k]),
                      .expected = name_of(truth(&trial[k])),
                      .found = "NOT_SURE",
                      .cause = "Of integers of at most 2^25, nothing "
                               "is rounded in differences and "
                               "products.");
    }
}

// The share at which the function is sure of all pairs, as a power.
static void doubt(uint64_t seed)
{
    struct random random = {seed};
    int power = 0, next = 12;
    const struct trial *doubted = NULL;
    for (; next <= 48; next += 12) {
        begin_case(MOST, -40);
        for (int k = 0; k < count; k++)
            make_trial(&random, &trial[k], ldexp(1 + k % 8, -next));
        doubted = ask(ldexp(1, -next));
        if (doubted)
            break;
        power = next;
    }
    kit_bands(
        48 - power, (struct kit_band[]){{0.5, 4}, {12.5, 2}, {0, 0}},
        (struct kit_fault){
            .where = doubted ? text_of(doubted) : NULL,
            .expected = "sure of times that differ by more than 2^-48 "
                        "of themselves",
            .found = kit_text("NOT_SURE, though they differ by more "
                              "than 2^-%d of themselves",
                              next),
            .cause = "Sum up the roundings, each of at most 2^-53 of "
                     "its result: there are few of them."});
}

const struct kit_test kit_tests[] = {
    {"true", 3, "no answer that is wrong", is_true},
    {"integers", 3, "always sure of small integers", integers},
    {"doubt", 4, "seldom not sure", doubt},
    {0},
};
