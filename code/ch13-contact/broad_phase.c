//> List the broad phases
// From the one that needs no proof to those that are fast.
#include "ch13-contact/broad_phase.h"
#include "ch13-contact/axis_sweep.h"
#include "ch13-contact/by_structure.h"
#include "ch13-contact/clusters.h"
#include "ch13-contact/sweep_and_prune.h"
#include <omp.h>
#include <string.h>

//> Look at all pairs
// The bar: n (n - 1) / 2 tests, and nothing to keep.
static void *begin_all(const struct broad_phase *phase)
{
    (void)phase;
    return NULL;
}

static void find_all(void *kept, const struct broad_search *search)
{
    (void)kept;
    const uint32_t n = search->boxes->n;
    const int threads = search->threads;
#pragma omp parallel for num_threads(threads) if (threads > 1) \
    schedule(dynamic, 64)
    for (uint32_t i = 0; i < n; i++) {
        struct pair_list *list =
            &search->pairs->list[omp_get_thread_num()];
        for (uint32_t j = i + 1; j < n; j++)
            add_if_overlapping(search, list, i, j);
        list->tested += n - i - 1;
    }
}

static void end_all(void *kept)
{
    (void)kept;
}
//<

//> Fill the table of broad phases
#define OF_STRUCTURE begin_structure, find_by_structure, end_structure
#define OF_CLUSTERS begin_clusters, find_by_clusters, end_clusters
const struct broad_phase broad_phases[] = {
    {"all-pairs", "every pair of boxes", NULL, begin_all, find_all,
     end_all},
    {"scan", "low corners, looked at by lanes", "scan-lanes",
     OF_STRUCTURE},
    {"projection", "low corners, sorted along each axis", "projection",
     OF_STRUCTURE},
    {"kd-tree", "low corners in a k-d tree, refitted", "kd-tree",
     OF_STRUCTURE},
    {"kd-tree-anew", "the same, built anew", "kd-tree-anew",
     OF_STRUCTURE},
    {"orthotree", "low corners in an octree", "orthotree-compressed",
     OF_STRUCTURE},
    {"cells", "low corners in cells", "cells", OF_STRUCTURE},
    {"cells-halves", "the same with binary searches", "cells-halves",
     OF_STRUCTURE},
    {"sweep", "along an axis, sorted anew", NULL, begin_sweep,
     find_by_sweep, end_sweep},
    {"sweep-kept", "along an axis, the order repaired", NULL,
     begin_sweep_kept, find_by_sweep, end_sweep},
    {"sweep-and-prune", "along three axes, order and pairs kept", NULL,
     begin_sweep_and_prune, find_by_sweep_and_prune,
     end_sweep_and_prune},
    {"clusters", "runs of triangles by kd-tree, then triangles",
     "kd-tree", OF_CLUSTERS},
    {"clusters-sweep", "the same, the runs by sweep-kept", "sweep-kept",
     OF_CLUSTERS},
    {"clusters-prune", "the same, by sweep-and-prune",
     "sweep-and-prune", OF_CLUSTERS},
};
const int broad_phase_count =
    sizeof broad_phases / sizeof *broad_phases;
//<

const struct broad_phase *find_broad_phase(const char *name)
{
    for (int row = 0; row < broad_phase_count; row++)
        if (strcmp(broad_phases[row].name, name) == 0)
            return &broad_phases[row];
    return NULL;
}

//> Find all pairs in order
void find_pairs(const struct broad_phase *phase, void *kept,
                const struct broad_search *search)
{
    pairs_begin(search->pairs, search->threads);
    if (search->boxes->n > 1)
        phase->find(kept, search);
    pairs_gather(search->pairs, search->boxes->n);
}
//<
//<
