//> Give every thread its own answers
// Each thread walks down its rows as if it were alone, in answers that
// no other thread sees. When all are done the points, not the rows, are
// shared out, and each point's best is chosen among the threads'. With
// T threads n T bests are merged: little beside n (n-1) / 2 distances.
#include "ch03-half-pairs/private.h"
#include "ch03-half-pairs/triangle.h"
#include "common/fail.h"
#include <stdlib.h>

//> Merge one thread's answer for a point
// Of equal distances the lower index wins, whichever thread has it.
static void merge(struct answers *answers, const struct answers *from,
                  uint32_t i)
{
    if (from->nearest2[i] < answers->nearest2[i] ||
        (from->nearest2[i] == answers->nearest2[i] &&
         from->nearest[i] < answers->nearest[i])) {
        answers->nearest2[i] = from->nearest2[i];
        answers->nearest[i] = from->nearest[i];
    }
    if (from->furthest2[i] > answers->furthest2[i] ||
        (from->furthest2[i] == answers->furthest2[i] &&
         from->furthest[i] < answers->furthest[i])) {
        answers->furthest2[i] = from->furthest2[i];
        answers->furthest[i] = from->furthest[i];
    }
}
//<

//> Compute apart, then reduce
// Monotonic: a thread's rows come in ascending order, as triangle_row
// wants them. The answers of the caller are thread 0's own.
void triangle_private(const struct question *question,
                      struct answers *answers, omp_sched_t schedule,
                      int chunk)
{
    uint32_t n = question->points.n;
    struct answers *private =
        allocate(question->threads, sizeof *private);
    omp_set_schedule(schedule, chunk);
#pragma omp parallel num_threads(question->threads)
    {
        struct answers *mine = &private[omp_get_thread_num()];
        *mine =
            omp_get_thread_num() == 0 ? *answers : answers_allocate(n);
        triangle_begin(mine, n);
#pragma omp for schedule(monotonic : runtime)
        for (uint32_t i = 0; i < n; i++) {
            triangle_row(question, mine, i);
        }
        //> Merge what the threads have found
#pragma omp for
        for (uint32_t i = 0; i < n; i++)
            for (int t = 1; t < omp_get_num_threads(); t++)
                merge(answers, &private[t], i);
        //<
        if (mine != private)
            answers_free(mine);
    }
    free(private);
}
//<

//> Give the private answers their schedule
void triangle_reduction(const struct question *question,
                        struct answers *answers)
{
    triangle_private(question, answers, omp_sched_dynamic, 32);
}
//<
//<
