// Counts the threads that work on a call: those that come to a function
// of the exercise, not those that a parallel region merely starts.
#include "grader.h"
#include <time.h>

void kit_at_work(int threads)
{
    enum { NAP = 100000, NAPS = 5000 }; // ns; half a second in all
    static _Thread_local bool known;
    struct trace *trace = grader.trace;
    if (known)
        return;
    known = true;
    if (trace->threads++ > 0 || threads < 2)
        return;
    for (int naps = 0; naps < NAPS && trace->threads < 2; naps++)
        nanosleep(&(struct timespec){.tv_nsec = NAP}, NULL);
    trace->alone = trace->threads < 2;
}

int kit_threads(void)
{
    return grader.trace->alone ? 1 : grader.trace->threads;
}

void kit_expect_threads(int threads)
{
    int found = kit_threads();
    if (threads < 2 || (found >= 2 && found <= threads))
        return;
    const char *expected =
        threads == 2 ? "2 threads at work at the same time"
                     : kit_text("2 to %d threads at work at the same "
                                "time",
                                threads);
    if (found > threads)
        WRONG(.expected = expected,
              .found = kit_text("%d threads", found),
              .cause = "A parallel region has as many threads as its "
                       "clause num_threads(threads) says.");
    if (found == 0)
        WRONG(.expected = expected, .found = "no thread at work",
              .cause = "The functions that are given were never "
                       "called.");
    WRONG(.expected = expected, .found = "one thread did all the work",
          .cause =
              "Is there a parallel region, and does its loop share "
              "the work among the threads? If all of it stands in "
              "a critical region, they take turns.");
}
