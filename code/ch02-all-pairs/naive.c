//> Search every pair, plainly
// Two loops: for every point, the distance to every other one, in
// ascending order of indices, so that of several at one distance the
// first is kept. n (n-1) distances; nothing is skipped, ever.
#include "ch02-all-pairs/naive.h"

//> Compare with every other point
static void search_row(const struct question *question,
                       struct answers *answers, uint32_t i)
{
    const struct points p = question->points;
    uint32_t nearest = i == 0, furthest = i == 0;
    double min2 = INFINITY, max2 = 0;
    for (uint32_t j = 0; j < p.n; j++) {
        if (j == i)
            continue;
        double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i];
        double near2 = closest2(question->space, dx, dy);
        double far2 = furthest2(question->space, dx, dy);
        if (near2 < min2) {
            min2 = near2;
            nearest = j;
        }
        if (far2 > max2) {
            max2 = far2;
            furthest = j;
        }
    }
    answers->nearest[i] = nearest;
    answers->nearest2[i] = min2;
    answers->furthest[i] = furthest;
    answers->furthest2[i] = max2;
    counts_add(question->counts,
               &(struct counts){.distances = p.n - 1});
}
//<

//> Share out the points among threads
void naive(const struct question *question, struct answers *answers)
{
#pragma omp parallel for num_threads(question->threads) schedule(static)
    for (uint32_t i = 0; i < question->points.n; i++)
        search_row(question, answers, i);
}
//<
//<
