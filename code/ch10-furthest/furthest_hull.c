//> Search the corners of the hull
// Every query is compared with every corner of the hull, eight queries
// at a time, each in a lane, as in chapter 2. Without a branch, and
// from the first cache; a few dozen distances a point if the points are
// spread evenly.
#include "ch10-furthest/furthest_hull.h"
#include <stdbool.h>

enum { QUERIES = 8, NO_CORNER = -1 };

//> Answer eight queries
static void answer_eight(const struct question *question,
                         const struct corners *corners, uint32_t begin,
                         struct answers *answers)
{
    const struct points p = question->points;
    const uint32_t left = p.n - begin;
    const uint32_t count = left < QUERIES ? left : QUERIES;
    double x[QUERIES], y[QUERIES];
    for (uint32_t lane = 0; lane < QUERIES; lane++) {
        uint32_t i = begin + (lane < count ? lane : 0);
        x[lane] = p.x[i];
        y[lane] = p.y[i];
    }
    //> Compare eight queries with every corner
    // A query may be compared with itself, too: it is at 0, not
    // further.
    const uint32_t n = corners->points.n;
    double max2[QUERIES] = {0};
    int64_t corner[QUERIES];
    for (int lane = 0; lane < QUERIES; lane++)
        corner[lane] = NO_CORNER;
    for (uint32_t k = 0; k < n; k++)
        for (int lane = 0; lane < QUERIES; lane++) {
            double far2 = distance2(corners->points.x[k] - x[lane],
                                    corners->points.y[k] - y[lane]);
            bool further = far2 > max2[lane];
            max2[lane] = further ? far2 : max2[lane];
            corner[lane] = further ? k : corner[lane];
        }
    //<
    for (uint32_t lane = 0; lane < count; lane++) {
        uint32_t i = begin + lane;
        answers->furthest2[i] = max2[lane];
        answers->furthest[i] = corner[lane] == NO_CORNER
                                   ? i == 0
                                   : corners->point[corner[lane]];
    }
}
//<

//> Share out the queries for a corner
void search_corners(const struct question *question,
                    const struct corners *corners,
                    struct answers *answers)
{
    const uint32_t n = question->points.n;
#pragma omp parallel for num_threads(question->threads) schedule(static)
    for (uint64_t begin = 0; begin < n; begin += QUERIES)
        answer_eight(question, corners, begin, answers);
    uint64_t distances = (uint64_t)n * corners->points.n;
    counts_add(question->counts,
               &(struct counts){.distances = distances});
}
//<

//> Find the corners and scan them
static void find_and_search(const struct question *question,
                            struct answers *answers)
{
    const struct corners corners =
        corners_find(question, question->workspace);
    note_built(question);
    search_corners(question, &corners, answers);
}

void furthest_hull(const struct question *question,
                   struct answers *answers)
{
    search_in_workspace(question, find_and_search, answers);
}
//<
//<
