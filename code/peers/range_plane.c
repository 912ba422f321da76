// Within a distance takes two passes: one counts, one fills lists that
// have just that length.
#include "peers/range_plane.h"
#include "ch12-range-queries/plane_neighbors.h"
#include "common/allocate.h"
#include "common/clock.h"
#include <math.h>
#include <stdlib.h>

// The lists have the length that a count has found.
static uint64_t list_within(const struct plane_index *index,
                            double reach2)
{
    const uint32_t n = index->pieces.sorted.points.n;
    uint32_t *count = allocate(n, sizeof *count);
    uint64_t *start = allocate((size_t)n + 1, sizeof *start);
    count_plane_within(index, reach2, count, NULL);
    start[0] = 0;
    for (uint32_t i = 0; i < n; i++)
        start[i + 1] = start[i] + count[i];
    const uint64_t found = start[n];
    const struct neighbor_lists lists = {
        0,
        n,
        0,
        start,
        allocate(found, sizeof(uint32_t)),
        allocate(found, sizeof(double))};
    fill_plane_lists(index, reach2, &lists, NULL);
    free(lists.index);
    free(lists.distance2);
    free(start);
    free(count);
    return found;
}

uint64_t answer_in_plane(struct range_scene *scene,
                         struct plane_times *times)
{
    const uint32_t n = scene->points.n;
    struct workspace workspace = {0};
    const struct question question = {
        {n, scene->points.x[0], scene->points.x[1]},
        {STANDARD, 0, 0},
        1};
    const int64_t begin = clock_ns();
    const struct plane_index index =
        plane_index_make(&question, &workspace);
    const int64_t built = clock_ns();
    const struct neighbor_lists lists = {
        0, n, NEIGHBORS_WANTED, NULL, scene->nearest, scene->nearest2};
    fill_plane_lists(&index, INFINITY, &lists, NULL);
    const int64_t nearest = clock_ns();
    const uint64_t found =
        list_within(&index, scene->distance * scene->distance);
    *times = (struct plane_times){built - begin, nearest - built,
                                  clock_ns() - nearest};
    workspace_free(&workspace);
    return found + n;
}
