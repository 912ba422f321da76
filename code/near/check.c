// A search through all pairs, written for this alone: it shares nothing
// with the algorithms that it judges but the measure of a distance.
#include "near/check.h"
#include "algorithms.h"
#include "near/progress.h"
#include <stdbool.h>

// Whether this is the distance of the nearest or of the furthest of all
// pairs that i is in, and the neighbor is at this distance.
static bool is_right(const struct question *question, enum answer kind,
                     uint32_t i, uint32_t neighbor, double distance2)
{
    const struct points p = question->points;
    double best2 = kind == NEAREST ? INFINITY : 0;
    bool found = false;
    for (uint32_t j = 0; j < p.n; j++) {
        if (j == i)
            continue;
        double dx = p.x[i] - p.x[j], dy = p.y[i] - p.y[j];
        double apart2 = kind == NEAREST
                            ? closest2(question->space, dx, dy)
                            : furthest2(question->space, dx, dy);
        if (kind == NEAREST ? apart2 < best2 : apart2 > best2)
            best2 = apart2;
        found |= j == neighbor && apart2 == distance2;
    }
    return found && distance2 == best2;
}

static void note_wrong(struct verdict *verdict, uint32_t i)
{
#pragma omp critical(note_wrong)
    {
        if (!verdict->wrong++ || i < verdict->first)
            verdict->first = i;
    }
}

struct verdicts check_answers(const struct question *question,
                              const struct answers *answers)
{
    struct verdicts verdicts = {0};
    uint32_t n = question->points.n;
    progress_start("checking", n);
#pragma omp parallel for schedule(dynamic, 32) \
    num_threads(question->threads)
    for (uint32_t i = 0; i < n; i++) {
        if (answers->nearest &&
            !is_right(question, NEAREST, i, answers->nearest[i],
                      answers->nearest2[i]))
            note_wrong(&verdicts.nearest, i);
        if (answers->furthest &&
            !is_right(question, FURTHEST, i, answers->furthest[i],
                      answers->furthest2[i]))
            note_wrong(&verdicts.furthest, i);
        progress_rows(1);
    }
    progress_stop();
    return verdicts;
}
