// A search through all pairs, written for this alone: it shares nothing
// with the algorithms that it judges but the measure of a distance.
#include "near/check.h"
#include "near/progress.h"
#include <stdbool.h>
static double measure(double (*image2)(struct space, double, double),
                      const struct question *question, uint32_t i,
                      uint32_t j)
{
    struct points p = question->points;
    return image2(question->space, p.x[i] - p.x[j], p.y[i] - p.y[j]);
}

static double true_nearest2(const struct question *question, uint32_t i)
{
    double best = INFINITY;
    for (uint32_t j = 0; j < question->points.n; j++) {
        double apart2 = measure(closest2, question, i, j);
        if (j != i && apart2 < best)
            best = apart2;
    }
    return best;
}

static double true_furthest2(const struct question *question,
                             uint32_t i)
{
    double best = 0;
    for (uint32_t j = 0; j < question->points.n; j++) {
        double apart2 = measure(furthest2, question, i, j);
        if (j != i && apart2 > best)
            best = apart2;
    }
    return best;
}
static bool is_right(double (*image2)(struct space, double, double),
                     const struct question *question, uint32_t i,
                     uint32_t neighbor, double distance2,
                     double true_distance2)
{
    return distance2 == true_distance2 &&
           neighbor < question->points.n && neighbor != i &&
           measure(image2, question, i, neighbor) == distance2;
}

static void condemn(struct verdict *verdict, uint32_t i)
{
#pragma omp critical(condemn)
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
            !is_right(closest2, question, i, answers->nearest[i],
                      answers->nearest2[i], true_nearest2(question, i)))
            condemn(&verdicts.nearest, i);
        if (answers->furthest &&
            !is_right(furthest2, question, i, answers->furthest[i],
                      answers->furthest2[i],
                      true_furthest2(question, i)))
            condemn(&verdicts.furthest, i);
        progress_row();
    }
    progress_stop();
    return verdicts;
}
