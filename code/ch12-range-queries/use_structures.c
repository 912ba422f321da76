//> Use the structures
// By name; and for all points, in an order in which what one query has
// brought into the caches is what the next one needs.
#include "ch12-range-queries/structures.h"
#include "common/allocate.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>

//> Find a structure
const struct structure *find_structure(const char *name)
{
    for (int row = 0; row < structure_count; row++)
        if (strcmp(structures[row].name, name) == 0)
            return &structures[row];
    return NULL;
}
//<

//> Bring a structure in line
void *structure_update(const struct structure *structure, void *built,
                       const struct point_set *points, int threads)
{
    if (structure->update) {
        structure->update(built, points);
        return built;
    }
    structure->discard(built);
    return structure->build(points, threads);
}
//<

//> Ask for one of all points
static void ask(const struct structure *structure, const void *built,
                uint32_t s, struct neighbor_query *query)
{
    const struct sorted_points *sorted = structure->walk_order(built);
    double at[MAX_DIMENSIONS];
    for (int k = 0; k < sorted->points.d; k++)
        at[k] = sorted->points.x[k][s];
    query->at = at;
    query->self = sorted->index[s];
    want_nearest(query, query->k);
    structure->neighbors(built, query);
    assert(query->count == query->k && "there are more points");
}
//<

void k_nearest_of_all(const struct structure *structure,
                      const void *built, uint32_t k, int threads,
                      uint32_t *nearest, double *nearest2)
{
    assert(structure->walk_order && "it finds neighbors");
    const struct sorted_points *sorted = structure->walk_order(built);
#pragma omp parallel num_threads(threads)
    {
        struct neighbor_query query = {
            .k = k, .found = allocate(k, sizeof *query.found)};
#pragma omp for schedule(dynamic, 1024)
        for (uint32_t s = 0; s < sorted->points.n; s++) {
            const size_t to = (size_t)sorted->index[s] * k;
            ask(structure, built, s, &query);
            for (uint32_t j = 0; j < k; j++) {
                nearest[to + j] = query.found[j].index;
                nearest2[to + j] = query.found[j].distance2;
            }
        }
        free(query.found);
    }
}
//<
