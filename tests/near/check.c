// What `near --check` rests on: a wrong answer must not pass.
#include "near/check.h"
#include "harness.h"
#include "status.h"
#include <stddef.h>

// Five points on a line: 0 1 3 6 10.
enum { n = 5 };

static struct verdicts judge(void (*spoil)(struct answers *))
{
    double x[n] = {0, 1, 3, 6, 10}, y[n] = {0};
    uint32_t nearest[n] = {1, 0, 1, 2, 3},
             furthest[n] = {4, 4, 4, 0, 0};
    double nearest2[n] = {1, 1, 4, 9, 16};
    double furthest2[n] = {100, 81, 49, 36, 100};
    struct question question = {{n, x, y}, {STANDARD, 1, 1}, 2};
    struct answers answers = {nearest, furthest, nearest2, furthest2};
    spoil(&answers);
    return check_answers(&question, &answers);
}

static void nothing(struct answers *answers)
{
    (void)answers;
}

static void nearest_not_nearest(struct answers *answers)
{
    answers->nearest[2] = 3, answers->nearest2[2] = 9;
}

static void nearest_too_near(struct answers *answers)
{
    answers->nearest2[3] = 8;
}

static void nearest_is_another(struct answers *answers)
{
    answers->nearest[3] = 4;
}

static void nearest_is_itself(struct answers *answers)
{
    answers->nearest[1] = 1, answers->nearest2[1] = 0;
}

static void nearest_is_nobody(struct answers *answers)
{
    answers->nearest[1] = answers->nearest[4] = n;
}

static void furthest_not_furthest(struct answers *answers)
{
    answers->furthest[0] = 3, answers->furthest2[0] = 36;
    answers->furthest[4] = 1, answers->furthest2[4] = 81;
}

static void furthest_too_far(struct answers *answers)
{
    answers->furthest2[4] = 101;
}

static void only_nearest(struct answers *answers)
{
    answers->furthest = NULL;
    answers->furthest2 = NULL;
}

static void wrong_answers_are_found(void)
{
    static const struct {
        const char *name;
        void (*spoil)(struct answers *);
        struct verdicts expected;
    } cases[] = {
        {"all right", nothing, {{0, 0}, {0, 0}}},
        {"not nearest", nearest_not_nearest, {{1, 2}, {0, 0}}},
        {"too near", nearest_too_near, {{1, 3}, {0, 0}}},
        {"another", nearest_is_another, {{1, 3}, {0, 0}}},
        {"itself", nearest_is_itself, {{1, 1}, {0, 0}}},
        {"nobody", nearest_is_nobody, {{2, 1}, {0, 0}}},
        {"not furthest", furthest_not_furthest, {{0, 0}, {2, 0}}},
        {"too far", furthest_too_far, {{0, 0}, {1, 4}}},
        {"no furthest", only_nearest, {{0, 0}, {0, 0}}},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct verdicts found = judge(cases[k].spoil);
        const char *name = cases[k].name;
        CHECK_INT(cases[k].expected.nearest.wrong, found.nearest.wrong,
                  "%s: wrong nearest", name);
        CHECK_INT(cases[k].expected.nearest.first, found.nearest.first,
                  "%s: the first of them", name);
        CHECK_INT(cases[k].expected.furthest.wrong,
                  found.furthest.wrong, "%s: wrong furthest", name);
        CHECK_INT(cases[k].expected.furthest.first,
                  found.furthest.first, "%s: the first of them", name);
    }
}

// Two points share a place: each is the other's nearest, at distance 0,
// but neither is its own.
static void duplicates_are_not_oneself(void)
{
    double x[2] = {1, 1}, y[2] = {2, 2}, zero[2] = {0, 0};
    uint32_t other[2] = {1, 0}, self[2] = {0, 1};
    struct question question = {{2, x, y}, {STANDARD, 1, 1}, 1};
    struct answers right = {other, other, zero, zero};
    struct answers wrong = {self, self, zero, zero};
    CHECK_INT(0, check_answers(&question, &right).nearest.wrong,
              "each other's");
    CHECK_INT(2, check_answers(&question, &wrong).nearest.wrong,
              "their own");
    CHECK_INT(2, check_answers(&question, &wrong).furthest.wrong,
              "their own furthest");
}

int main(void)
{
    return RUN_TESTS("near", TEST(wrong_answers_are_found),
                     TEST(duplicates_are_not_oneself),
                     TEST(a_mistake_has_status_1));
}
