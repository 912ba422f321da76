//> Find pairs by clusters
// Neighbors in a mesh are neighbors in space, mostly; where they are
// not, the boxes of clusters are larger, and the pairs the same.
// Clusters of the same rigid body are never compared, and so most of
// the work that triangles would have with their own body is not done.
// A triangle costs one test of boxes for each cluster that its own one
// meets, and one for each triangle that reaches into its cluster's box.
#include "ch13-contact/clusters.h"
#include "common/allocate.h"
#include "common/points.h"
#include <omp.h>
#include <stdlib.h>
#include <string.h>

//> Hold clusters
struct clusters {
    uint32_t *begin; // begin[c]: the first triangle of cluster c
    uint32_t *group; // as of its triangles
    uint32_t room;   // for triangles
    uint32_t n;      // clusters
    struct boxes boxes;
    struct pairs pairs;                      // of clusters
    const struct broad_phase *cluster_phase; // finds these
    void *kept;                              // by it
};
//<

//> Keep clusters
void *begin_clusters(const struct broad_phase *phase)
{
    struct clusters *clusters = allocate(1, sizeof *clusters);
    *clusters = (struct clusters){.cluster_phase =
                                      find_broad_phase(phase->inner)};
    clusters->kept =
        clusters->cluster_phase->begin(clusters->cluster_phase);
    return clusters;
}

void end_clusters(void *kept)
{
    struct clusters *clusters = kept;
    free(clusters->begin);
    free(clusters->group);
    boxes_free(&clusters->boxes);
    pairs_free(&clusters->pairs);
    clusters->cluster_phase->end(clusters->kept);
    free(clusters);
}
//<

//> Cut the mesh into clusters
// A new one where the last is full, or another group begins.
static void cut_mesh(struct clusters *clusters,
                     const struct broad_search *search)
{
    const uint32_t n = search->boxes->n;
    if (n > clusters->room) {
        free(clusters->begin);
        free(clusters->group);
        clusters->begin =
            allocate((size_t)n + 1, sizeof *clusters->begin);
        clusters->group = allocate(n, sizeof *clusters->group);
        clusters->room = n;
    }
    uint32_t c = 0;
    for (uint32_t t = 0; t < n; t++) {
        const uint32_t group =
            search->group ? search->group[t] : NO_INDEX;
        if (c == 0 || t - clusters->begin[c - 1] == CLUSTER ||
            group != clusters->group[c - 1]) {
            clusters->begin[c] = t;
            clusters->group[c++] = group;
        }
    }
    clusters->begin[c] = n;
    clusters->n = c;
}
//<

//> Find the boxes of clusters
static void enclose(struct clusters *clusters,
                    const struct boxes *boxes, int threads)
{
    boxes_reserve(&clusters->boxes, clusters->n);
#pragma omp parallel for num_threads(threads) if (threads > 1)
    for (uint32_t c = 0; c < clusters->n; c++)
        boxes_unite(&clusters->boxes, c, boxes, clusters->begin[c],
                    clusters->begin[c + 1]);
}
//<

//> List what reaches into a cluster's box
static int list_reaching(const struct broad_search *search,
                         const struct clusters *clusters,
                         struct pair pair, uint32_t reaching[CLUSTER])
{
    int count = 0;
    for (uint32_t t = clusters->begin[pair.one];
         t < clusters->begin[pair.one + 1]; t++) {
        reaching[count] = t;
        count +=
            box_meets(search->boxes, t, &clusters->boxes, pair.other);
    }
    return count;
}
//<

//> Compare two clusters
static uint32_t size_of(const struct clusters *clusters, uint32_t c)
{
    return clusters->begin[c + 1] - clusters->begin[c];
}

static void compare_clusters(const struct broad_search *search,
                             const struct clusters *clusters,
                             struct pair pair, struct pair_list *list)
{
    uint32_t one[CLUSTER], other[CLUSTER];
    const int ones = list_reaching(search, clusters, pair, one);
    const int others = list_reaching(
        search, clusters, (struct pair){pair.other, pair.one}, other);
    for (int i = 0; i < ones; i++)
        for (int j = 0; j < others; j++)
            add_if_overlapping(search, list, one[i], other[j]);
    list->tested += size_of(clusters, pair.one) +
                    size_of(clusters, pair.other) +
                    (uint64_t)ones * others;
}

// Each pair of a cluster with itself.
static void compare_within(const struct broad_search *search,
                           const struct clusters *clusters, uint32_t c,
                           struct pair_list *list)
{
    if (clusters->group[c] != NO_INDEX)
        return;
    const uint32_t end = clusters->begin[c + 1];
    for (uint32_t i = clusters->begin[c]; i < end; i++) {
        for (uint32_t j = i + 1; j < end; j++)
            add_if_overlapping(search, list, i, j);
        list->tested += end - i - 1;
    }
}
//<

//> Go over pairs of clusters
void find_by_clusters(void *kept, const struct broad_search *search)
{
    struct clusters *clusters = kept;
    const int threads = search->threads;
    cut_mesh(clusters, search);
    enclose(clusters, search->boxes, threads);
    const struct broad_search of_clusters = {
        &clusters->boxes, clusters->group, &clusters->pairs, threads};
    find_pairs(clusters->cluster_phase, clusters->kept, &of_clusters);
#pragma omp parallel num_threads(threads) if (threads > 1)
    {
        struct pair_list *list =
            &search->pairs->list[omp_get_thread_num()];
#pragma omp for schedule(dynamic, 64) nowait
        for (uint32_t c = 0; c < clusters->n; c++)
            compare_within(search, clusters, c, list);
#pragma omp for schedule(dynamic, 64)
        for (uint64_t p = 0; p < clusters->pairs.count; p++)
            compare_clusters(search, clusters, clusters->pairs.pair[p],
                             list);
    }
    search->pairs->list[0].tested += clusters->pairs.tested;
}
//<
//<
