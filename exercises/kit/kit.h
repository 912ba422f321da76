// The grading kit: what the tests.c of an exercise is written with.
//
// The grader is kit.c, judge.c, tests.c and the modules of code/common.
// The student's file is a shared library which the grader itself never
// loads: only what stands in CALL(...) runs with it, in a process of
// its own with limits of time, memory and output. All that comes back
// is what it wrote to the arrays of kit_output. A crash, an endless
// loop or an exit() is therefore one failed test and not the end.
#pragma once
#include "common/points.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// None of these names can be seen from the student's library.
#pragma GCC visibility push(hidden)

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
//
// A process costs far more than most answers, so a CALL may hold many
// cases. Then each says there what it is given, and is checked there,
// too: what is WRONG ends the call before a later case does harm. That
// is no verdict. The judge checks all cases again, and comes to it.
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

// Where a picture helps: the points, and two of them, in the answer and
// in the right one. build/work/2.1/wrong.png shows the first.
struct kit_picture {
    struct points points;
    uint32_t found[2], right[2];
};

// The cells to draw behind it, if there are any.
struct kit_cells {
    uint32_t columns, rows;
    const double *column_border; // [0 .. columns]
    const double *row_border;    // [0 .. rows]
};

// The test has failed and ends here. What does not apply stays NULL.
struct kit_fault {
    const char *where;    // which point, where it lies
    const char *expected; // and what was
    const char *found;    // instead
    const char *cause;    // the likely one, in a sentence
    int points;           // what is earned all the same
    struct kit_picture picture;
    struct kit_cells cells;
};
#define WRONG(...) kit_wrong((struct kit_fault){__VA_ARGS__})
_Noreturn void kit_wrong(struct kit_fault fault);

// The likely cause if a CALL takes too long, from here to the end of
// the test.
void kit_if_endless(const char *cause);

// The test cannot be graded here and now, and says why. Its points are
// neither earned nor lost.
_Noreturn void kit_not_graded(const char *why);

// ---- marks in bands ------------------------------------------------

// The test passes if the value is within the first band; otherwise it
// has failed, but keeps the points of the band in which the value is.
// A row without anything ends the bands.
struct kit_band {
    double most;
    int points;
};
void kit_bands(double value, const struct kit_band *bands,
               struct kit_fault fault);

// By which power of n a cost grows: the slope of the straight line
// through (log n, log cost). Costs are counts, greater than 0.
double kit_growth(int count, const double *n, const double *cost);

// How many times as long as the reference the student's function takes.
// Each of the two functions makes one CALL, of 20 ms or more; they run
// in turn, and the best times count: of the processor if it is for one
// core, or else as the clock says; but fifty times is lost at once.
// Does not return where the machine has not so many cores, or where the
// times do not settle. With the sanitizers there is nothing to measure:
// 0.
struct kit_race {
    void (*student)(void), (*reference)(void);
    int cores;
    int trials; // of each at least; 0: five
};
double kit_race(struct kit_race race);

// Of the last CALL, as the judge saw it; of all processors together, or
// by the clock.
double kit_seconds(bool by_clock);
bool kit_is_sanitized(void);

// ---- threads -------------------------------------------------------

// A given function of an exercise with threads calls this first, with
// the number of threads that were asked for. The first thread that
// comes waits half a second for another one.
void kit_at_work(int threads);

// Of the last CALL: how many threads came, or 1 if the first one waited
// in vain. So it is 1 where one thread does all the work, and where all
// of the work stands in a critical region.
int kit_threads(void);

// After CALL: the test fails if so many threads were asked for and one
// did all the work, or more came than were asked for.
void kit_expect_threads(int threads);

// ---- text ----------------------------------------------------------

// Text for a fault; lasts as long as the arrays.
const char *kit_text(const char *format, ...)
    __attribute__((format(printf, 1, 2)));
const char *kit_point(struct points points, uint32_t i);

#pragma GCC visibility pop
