//> Search every pair, plainly
// See naive.h.
#include "ch02-all-pairs/naive.h"
#include "common/count.h"

//> Ask every other point
static void ask_everyone(const struct question *question,
                         struct answers *answers, uint32_t i)
{
    const struct points p = question->points;
    uint32_t nearest = i == 0, furthest = i == 0;
    double least2 = INFINITY, most2 = 0;
    for (uint32_t j = 0; j < p.n; j++) {
        if (j == i)
            continue;
        double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i];
        double near2 = closest2(question->space, dx, dy);
        double far2 = furthest2(question->space, dx, dy);
        if (near2 < least2) {
            least2 = near2;
            nearest = j;
        }
        if (far2 > most2) {
            most2 = far2;
            furthest = j;
        }
    }
    answers->nearest[i] = nearest;
    answers->nearest2[i] = least2;
    answers->furthest[i] = furthest;
    answers->furthest2[i] = most2;
    COUNT(distances, p.n - 1);
}
//<

//> Share out the points among threads
void naive(const struct question *question, struct answers *answers)
{
#pragma omp parallel for num_threads(question->threads) schedule(static)
    for (uint32_t i = 0; i < question->points.n; i++)
        ask_everyone(question, answers, i);
}
//<
//<
