//> Search the corners of the hull
// See furthest_hull.h.
#include "ch10-furthest/furthest_hull.h"
#include "common/clock.h"
#include "common/count.h"
#include <stdbool.h>

//> Let eight ask every corner
// Nobody is further from himself than 0, so all may ask about all.
enum { ASKING = 8, NO_CORNER = -1 };

static void ask_corners(const struct corners *corners, const double *x,
                        const double *y, double *furthest2,
                        int64_t *furthest)
{
    const uint32_t n = corners->points.n;
    double most2[ASKING] = {0};
    int64_t corner[ASKING];
    for (int lane = 0; lane < ASKING; lane++)
        corner[lane] = NO_CORNER;
    for (uint32_t k = 0; k < n; k++)
        for (int lane = 0; lane < ASKING; lane++) {
            double far2 = distance2(corners->points.x[k] - x[lane],
                                    corners->points.y[k] - y[lane]);
            bool further = far2 > most2[lane];
            most2[lane] = further ? far2 : most2[lane];
            corner[lane] = further ? k : corner[lane];
        }
    for (int lane = 0; lane < ASKING; lane++) {
        furthest2[lane] = most2[lane];
        furthest[lane] = corner[lane];
    }
}
//<

//> Answer eight questions
static void answer_eight(const struct question *question,
                         const struct corners *corners, uint32_t begin,
                         struct answers *answers)
{
    const struct points p = question->points;
    const uint32_t left = p.n - begin;
    const uint32_t asking = left < ASKING ? left : ASKING;
    double x[ASKING], y[ASKING], furthest2[ASKING];
    int64_t furthest[ASKING];
    for (uint32_t lane = 0; lane < ASKING; lane++) {
        uint32_t i = begin + (lane < asking ? lane : 0);
        x[lane] = p.x[i];
        y[lane] = p.y[i];
    }
    ask_corners(corners, x, y, furthest2, furthest);
    for (uint32_t lane = 0; lane < asking; lane++) {
        uint32_t i = begin + lane;
        answers->furthest2[i] = furthest2[lane];
        answers->furthest[i] = furthest[lane] == NO_CORNER
                                   ? i == 0
                                   : corners->point[furthest[lane]];
    }
}
//<

//> Share out the questions to the corners
void search_corners(const struct question *question,
                    const struct corners *corners,
                    struct answers *answers)
{
    const uint32_t n = question->points.n;
#pragma omp parallel for num_threads(question->threads) schedule(static)
    for (uint64_t begin = 0; begin < n; begin += ASKING)
        answer_eight(question, corners, begin, answers);
    COUNT(distances, (uint64_t)n * corners->points.n);
}

void furthest_hull(const struct question *question,
                   struct answers *answers)
{
    struct corners corners = corners_find(question);
    answers->built_ns = clock_ns();
    search_corners(question, &corners, answers);
    corners_free(&corners);
}
//<
//<
