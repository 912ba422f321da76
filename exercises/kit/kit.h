// The grading kit: what the tests.c of an exercise is written with.
//
// The grader is kit.c, tests.c and the modules of code/common. The
// student's file is a shared library which the grader itself never
// loads: only what stands in CALL(...) runs with it, in a process of
// its own with limits of time, memory and output. All that comes back
// is what it wrote to the arrays of kit_output. A crash, an endless
// loop or an exit() is therefore one failed test and not the end.
#pragma once
#include "common/points.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// A tests.c defines this table; a row without a name ends it.
struct kit_test {
    const char *name;  // one word, as in make exercise2.1 TEST=name
    int points;        // what it is worth
    const char *about; // what holds if it passes
    void (*run)(uint64_t seed);
};
extern const struct kit_test kit_tests[];

// Arrays that end where a page of memory ends: one element further,
// and the student's process stops with a message that names the array.
// It may only read an input; an output is filled with nonsense first.
// They last until the test ends or kit_next_case is called.
void *kit_input(const char *name, size_t count, size_t size);
void *kit_output(const char *name, size_t count, size_t size);
void kit_next_case(void);

// An input of n points of one of the book's distributions.
struct points kit_points(const char *distribution, uint32_t n,
                         uint64_t seed);

// What the function is given; failures say it. kit_points sets it.
void kit_given(const char *format, ...)
    __attribute__((format(printf, 1, 2)));

// CALL(*found = STUDENT(nearest_pair)(points));
#define STUDENT(function) \
    ((__typeof__(&function))kit_function(#function))
#define CALL(...)          \
    do {                   \
        if (kit_enter()) { \
            __VA_ARGS__;   \
            kit_leave();   \
        }                  \
    } while (0)
bool kit_enter(void);
_Noreturn void kit_leave(void);
void (*kit_function(const char *name))(void);

// The test has failed and ends here. What does not apply stays NULL.
struct kit_fault {
    const char *where;    // which point, where it lies
    const char *expected; // and what was
    const char *found;    // instead
    const char *cause;    // the likely one, in a sentence
};
#define WRONG(...) kit_wrong((struct kit_fault){__VA_ARGS__})
_Noreturn void kit_wrong(struct kit_fault fault);

// Text for a fault; lasts as long as the arrays.
const char *kit_text(const char *format, ...)
    __attribute__((format(printf, 1, 2)));
const char *kit_point(struct points points, uint32_t i);
