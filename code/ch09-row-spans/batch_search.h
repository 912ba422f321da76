//> Declare the batch search
// The driver of the fast searches: walks along the rows of the grid,
// stages the candidates of up to QUERIES queries at a time, and lets a
// kernel answer for each batch of them. What a kernel cannot certify is
// answered exactly, query by query. Nearest and furthest are a kernel
// and an exact query each; several searches share the staging.
#pragma once
#include "ch05-collisions/partition.h"
#include "ch09-row-spans/batch.h"

//> Declare an exact query
enum { QUERIES = 40, CHUNK = 1024 };

//> Hold an answer on its way
struct neighbor {
    double distance2;
    uint32_t index; // of the neighbor
};
//<

// Answers for sorted point s. Found is what the kernel has found but
// could not certify, or has the index NO_INDEX.
typedef void exact_query(const struct scene *scene, const void *context,
                         uint32_t s, struct neighbor *found,
                         struct counts *counts);
//<

//> Hold a search of the driver
struct batch_search {
    batch_kernel *kernel;
    double max_reach; // of a staging buffer that the kernel is given;
                      // INFINITY: any
    exact_query *exact;
    const void *context; // for exact
    struct neighbor *results;
    const uint32_t *inverse; // sorted point s has results[inverse[s]]
    uint32_t *index;         // the neighbor of each point of the input
    double *distance2; // and how far it is, once order is restored
};
//<

// Answers for the sorted points begin .. end - 1, begin < end, on one
// thread, by so many searches.
void answer_chunk(const struct scene *scene,
                  const struct batch_search *searches, int count,
                  uint32_t begin, uint32_t end, struct counts *counts);

//> Share out chunks
// Does some work for the points begin .. end - 1, and counts it.
typedef void chunk_function(const void *context, uint32_t begin,
                            uint32_t end, struct counts *counts);

// For all points of the question in chunks, by all its threads.
void share_chunks(const struct question *question, chunk_function *work,
                  const void *context);
//<

// Answers for all sorted points, by all threads of the question.
void answer_all(const struct question *question,
                const struct scene *scene,
                const struct batch_search *searches, int count);

// The same with results that are taken from the workspace and given
// back, for points that were partitioned with RESTORE; then the order
// of the input is restored.
void answer_in_order(const struct question *question,
                     const struct scene *scene,
                     const struct partition *partition,
                     struct workspace *workspace,
                     struct batch_search *searches, int count);

//> Declare how order is restored
// Queries run in the order of the cells, and their answers are wanted
// in the order of the input. So answers go back the way that points
// came: first to where the point's record was, which is in the same
// bucket, and so in a cache; then, read in the order of the input, from
// as many streams as there are buckets. Of n points; permutation[i]
// says in which result point i has its neighbor. By so many threads.
void restore_order(const struct neighbor *results,
                   const uint32_t *permutation, uint32_t n, int threads,
                   uint32_t *index, double *distance2);
//<
//<
