// Tests of the earlier fall: answers against the real numbers, which
// are integers of 53 bits times a power of two, so that 128 bits hold
// their products; and how often it is not sure.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

enum { MOST = 20000 };
__extension__ typedef __int128 wide;

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

static wide integer_of(double x)
{
    return (wide)ldexp(x, -scale);
}

// The product of two differences.
static wide product(double a, double b, double c, double d)
{
    return (integer_of(a) - integer_of(b)) *
           (integer_of(c) - integer_of(d));
}

static enum first truth(const struct trial *t)
{
    const wide of_p = product(t->p.begin, t->floor, t->floor, t->q.end);
    const wide of_q = product(t->q.begin, t->floor, t->floor, t->p.end);
    return of_p == of_q ? BOTH : of_p < of_q ? FIRST_P : FIRST_Q;
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

// By which part of the earlier time the two times differ.
static double share_of(const struct trial *t)
{
    const wide of_p = product(t->p.begin, t->floor, t->floor, t->q.end);
    const wide of_q = product(t->q.begin, t->floor, t->floor, t->p.end);
    const struct fall *first = of_p < of_q ? &t->p : &t->q;
    const struct fall *later = of_p < of_q ? &t->q : &t->p;
    const wide unit =
        product(first->begin, t->floor, later->begin, later->end);
    return fabs((double)(of_p - of_q)) / (double)unit;
}

// Runs all trials: none may be wrong. Returns how many were not sure
// though the times differ by more than this part.
static int ask(double part)
{
    CALL(for (int k = 0; k < count; k++) found[k] = STUDENT(earlier)(
             trial[k].floor, &trial[k].p, &trial[k].q));
    int doubts = 0;
    for (int k = 0; k < count; k++) {
        const enum first right = truth(&trial[k]);
        if (found[k] == NOT_SURE)
            doubts += share_of(&trial[k]) > part;
        else if (found[k] != right)
            WRONG(.where = text_of(&trial[k]),
                  .expected =
                      kit_text("%s or NOT_SURE", name_of(right)),
                  .found = name_of(found[k]),
                  .cause = cause_of(found[k], right));
    }
    return doubts;
}

static void is_true(uint64_t seed)
{
    struct random random = {seed};
    for (int part = 0; part < 3; part++) {
        begin_case(MOST, -60 + 30 * part);
        for (int k = 0; k < count; k++)
            make_trial(&random, &trial[k],
                       k % 2 ? 0 : ldexp(1, -(k % 54)));
        if (ask(-1) == count)
            WRONG(.expected = "an answer", .found = "NOT_SURE, always",
                  .cause = "Half of these pairs differ by far.");
    }
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
    int power = 0;
    for (int next = 12; next <= 48; next += 12) {
        begin_case(MOST, -40);
        for (int k = 0; k < count; k++)
            make_trial(&random, &trial[k], ldexp(1 + k % 8, -next));
        if (ask(ldexp(1, -next)) > 0)
            break;
        power = next;
    }
    kit_bands(
        48 - power, (struct kit_band[]){{0.5, 4}, {12.5, 2}, {0, 0}},
        (struct kit_fault){
            .expected = "sure if times differ by a part of 2^48",
            .found =
                power == 0
                    ? "not sure at a part of 4096"
                    : kit_text("sure only at a part of 2^%d", power),
            .cause = "Sum up the roundings, each a part of 2^53: there "
                     "are few of them."});
}

const struct kit_test kit_tests[] = {
    {"true", 3, "no answer that is wrong", is_true},
    {"integers", 3, "always sure of small integers", integers},
    {"doubt", 4, "seldom not sure", doubt},
    {0},
};
