// The checks that every test of the book uses. A check that fails says
// what was expected, what was found, and the seed of the random points
// if the test has set one; the test then goes on. Checks belong to one
// thread: never call them inside a parallel region.
#pragma once
#include "common/question.h"
#include <stdbool.h>
#include <stdint.h>

// So many, or fewer if the environment sets MOST_POINTS or MOST_CASES,
// whichever is named here: a sanitizer is slow.
uint32_t at_most(const char *variable, uint32_t count);

// The seed that failures mention from now on, until the test ends.
void test_seed(uint64_t seed);

// Each takes a printf format and its arguments last, which name what
// was checked: CHECK_INT(3, found, "neighbor of point %u", i).
#define CHECK(condition, ...) \
    check_true(__FILE__, __LINE__, #condition, condition, __VA_ARGS__)
#define CHECK_INT(expected, found, ...) \
    check_int(__FILE__, __LINE__, expected, found, __VA_ARGS__)
// The same number to the last bit.
#define CHECK_DOUBLE(expected, found, ...) \
    check_near(__FILE__, __LINE__, expected, found, 0, __VA_ARGS__)
#define CHECK_NEAR(expected, found, tolerance, ...)            \
    check_near(__FILE__, __LINE__, expected, found, tolerance, \
               __VA_ARGS__)
#define CHECK_TEXT(expected, found, ...) \
    check_text(__FILE__, __LINE__, expected, found, __VA_ARGS__)
// work(context), run in a process of its own, must end with status 2
// and say the sentence (or more) on stderr.
#define CHECK_FAILS(sentence, work, context, ...)            \
    check_fails(__FILE__, __LINE__, sentence, work, context, \
                __VA_ARGS__)

// Each returns whether the check held.
bool check_true(const char *file, int line, const char *condition,
                bool found, const char *what, ...)
    __attribute__((format(printf, 5, 6)));
bool check_int(const char *file, int line, long long expected,
               long long found, const char *what, ...)
    __attribute__((format(printf, 5, 6)));
bool check_near(const char *file, int line, double expected,
                double found, double tolerance, const char *what, ...)
    __attribute__((format(printf, 6, 7)));
bool check_text(const char *file, int line, const char *expected,
                const char *found, const char *what, ...)
    __attribute__((format(printf, 5, 6)));
bool check_fails(const char *file, int line, const char *sentence,
                 void (*work)(void *), void *context, const char *what,
                 ...) __attribute__((format(printf, 6, 7)));

// The plainest search there is, which shares nothing with those of the
// book but the distance: the lowest of the nearest, the lowest of the
// furthest.
void search_plainly(const struct question *question,
                    struct answers *answers);

// Others, the near ones first, of those that are as near the one with
// the lower index.
struct other {
    double distance2;
    uint32_t index;
};
void sort_plainly(struct other *others, uint32_t count);

// A test program is one line:
// int main(void) { return RUN_TESTS("ch02", TEST(one), TEST(two)); }
struct test {
    const char *name;
    void (*run)(void);
};
#define TEST(function) ((struct test){#function, function})
#define RUN_TESTS(folder, ...)                       \
    run_tests(folder, (struct test[]){__VA_ARGS__},  \
              sizeof((struct test[]){__VA_ARGS__}) / \
                  sizeof(struct test))

// Runs the tests, prints the failures and, alone on the last line,
// "N passed, N failed"; writes $BUILD/tests/FOLDER.xml. Returns main's
// status: 0, or 1 if any failed or none ran.
int run_tests(const char *folder, const struct test *tests, int n);
