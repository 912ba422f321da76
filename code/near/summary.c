// Looks at all answers once more, for what a user should know of them:
// squares beyond the range of a double, and the mean distances.
#include "near/summary.h"
#include <float.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>

// Whether the closest images are in different places.
bool are_apart(const struct question *question, uint32_t i, uint32_t j)
{
    struct points p = question->points;
    struct space space = question->space;
    double dx = fabs(p.x[i] - p.x[j]), dy = fabs(p.y[i] - p.y[j]);
    bool wraps = space.geometry == WRAPAROUND;
    return !(dx == 0 || (wraps && dx == space.width)) ||
           !(dy == 0 || (wraps && dy == space.height));
}

void warn_of_range(const struct question *question,
                   const struct answers *answers)
{
    uint32_t *nearest = answers->nearest;
    bool over = false, under = false;
    for (uint32_t i = 0; i < question->points.n; i++) {
        over |= answers->furthest && isinf(answers->furthest2[i]);
        over |= nearest && isinf(answers->nearest2[i]);
        under |= nearest && answers->nearest2[i] < DBL_MIN &&
                 are_apart(question, i, nearest[i]);
    }
    warn_of_squares(over, under);
}

void warn_of_squares(bool over, bool under)
{
    if (over || under)
        fprintf(stderr,
                "near: warning: some points are too %s for their "
                "squared distance, which is taken as %s; scale the "
                "coordinates\n",
                over ? "far apart" : "close together",
                over ? "infinite" : "zero or nearly so");
}

static void summarize_distances(const char *kind,
                                const double *distance2, uint32_t n)
{
    double sum = 0;
    for (uint32_t i = 0; i < n; i++)
        sum += sqrt(distance2[i]);
    printf("%-9s %.7g on average\n", kind, sum / n);
}

void print_summary(const struct options *options,
                   const struct question *question,
                   const struct answers *answers)
{
    uint32_t n = question->points.n;
    printf("points    %" PRIu32 " %s%s\n", n,
           options->file ? "from " : options->distribution->name,
           options->file ? options->file : "");
    printf("geometry  %s\n",
           options->geometry == STANDARD ? "standard" : "wraparound");
    if (answers->nearest)
        summarize_distances("nearest", answers->nearest2, n);
    if (answers->furthest)
        summarize_distances("furthest", answers->furthest2, n);
}
