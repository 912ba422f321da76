// What the files of the grader share; a tests.c sees kit.h only. For
// the student's process it is a copy, from which nothing comes back but
// the trace and the outputs.
#pragma once
#include "kit.h"
#include <setjmp.h>
#include <stdatomic.h>
#include <stdio.h>

// None of these names can be seen from the student's library.
#pragma GCC visibility push(hidden)

enum {
    ARRAYS_MAX = 64,
    POISON = 0xa5, // fills an array's pages
};

struct array {
    const char *name;
    char *pages, *start, *end; // end: where the closing page begins
    size_t size;               // of an element
    bool input;
};

// What the student's process leaves behind, besides the outputs.
struct trace {
    bool loaded, finished;
    char problem[256];   // why its file cannot be used
    char given[256];     // to which of several cases of one call
    char *address;       // of an access that the machine refused
    _Atomic int threads; // that came to kit_at_work
    bool alone;          // the first of them stayed
    // When its time is over it is asked where it is: the place in its
    // library, or 0, and which of our functions it had called there.
    volatile bool asked;
    size_t place;
    char called[64];
};

struct grader {
    const char *source; // as the student knows it
    const char *library;
    uint64_t seed;
    const char *lost;    // why every test is, or NULL
    const char *verdict; // on every test, if so
    const char *until;   // words of a failure that is the last, or NULL
    int file;            // the library, open
    int fence;           // around it, built once; or -1
    double limit;        // seconds a call may take
    int stops;           // calls that took more
    double allowed;      // and might, before time was lost
    double budget;       // and all that are still to come
    double seconds;      // that the last one took, by the clock
    double processor_seconds;
    int printed; // the file that catches what a call prints
    FILE *scores;
    const char *picture; // the file to draw; NULL: done, or not wanted
    struct trace *trace;

    // of the test that runs
    struct array arrays[ARRAYS_MAX];
    int array_count;
    char given[256], text[4096];
    size_t text_length;
    const char *status;
    const char *endless; // why a call of the test may be; or NULL
    struct kit_fault fault;
    double ratio; // to the reference's time; 0 if that was not taken
    jmp_buf end;
};
extern struct grader grader;

// The name of the open library, for the process that asks.
const char *loaded_name(void);

// What, and in which line of the student's file the machine code at
// this place of its library stands, if that can be found.
const char *at_place(const char *what, const char *place);

// The test has failed, for what the student's process did, and ends.
_Noreturn void broken(const char *status, const char *found,
                      const char *cause);

// Where a sanitizer's report begins, or else the end of the text.
char *find_report(char *printed);

// Does not return if the process, which has ended with this status and
// this report, did anything but its work.
void judge(int status, const char *report);

#pragma GCC visibility pop
