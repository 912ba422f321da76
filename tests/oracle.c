// What is right: the plainest search there is, which shares nothing
// with those of the book but the distance. Much of the tests' time is
// spent here, so the compiler shall find loops for its lanes, and the
// Makefile leaves the sanitizers out.
#include "common/allocate.h"
#include "common/geometry.h"
#include "harness.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// The lowest index of a point that is so far away, but for i itself; or
// of the first other, if all are further away than numbers reach.
static uint32_t find(double wanted, const double *distance2, uint32_t n,
                     uint32_t i)
{
    uint32_t j = 0;
    while (j < n && (j == i || distance2[j] != wanted))
        j++;
    return j < n ? j : i == 0;
}

void search_plainly(const struct question *question,
                    struct answers *answers)
{
    const struct points p = question->points;
    const struct space space = question->space;
    double *close2 = allocate(p.n, sizeof *close2);
    double *wide2 = allocate(p.n, sizeof *wide2);
    for (uint32_t i = 0; i < p.n; i++) {
        for (uint32_t j = 0; j < p.n; j++) {
            const double dx = p.x[i] - p.x[j], dy = p.y[i] - p.y[j];
            close2[j] = closest2(space, dx, dy);
            wide2[j] = furthest2(space, dx, dy);
        }
        close2[i] = INFINITY; // nobody is one's own neighbor
        wide2[i] = 0;
        double near2 = INFINITY, far2 = 0;
#pragma omp simd reduction(min : near2) reduction(max : far2)
        for (uint32_t j = 0; j < p.n; j++) {
            near2 = close2[j] < near2 ? close2[j] : near2;
            far2 = wide2[j] > far2 ? wide2[j] : far2;
        }
        answers->nearest[i] = find(near2, close2, p.n, i);
        answers->nearest2[i] = close2[answers->nearest[i]];
        answers->furthest[i] = find(far2, wide2, p.n, i);
        answers->furthest2[i] = wide2[answers->furthest[i]];
    }
    free(wide2);
    free(close2);
}

// Two are never the same.
static int nearer(const void *left, const void *right)
{
    struct other two[2];
    memcpy(&two[0], left, sizeof *two);
    memcpy(&two[1], right, sizeof *two);
    if (two[0].distance2 == two[1].distance2)
        return two[0].index < two[1].index ? -1 : 1;
    return two[0].distance2 < two[1].distance2 ? -1 : 1;
}

void sort_plainly(struct other *others, uint32_t count)
{
    qsort(others, count, sizeof *others, nearer);
}
