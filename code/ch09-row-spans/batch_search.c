//> Drive the batch search
// Four loops: rows of cells, staging buffers for up to five batches,
// batches, searches. Where points crowd too much for a buffer, queries
// are answered exactly. About 9 c + 22 distances each, c to a cell.
#include "ch09-row-spans/batch_search.h"
#include "ch09-row-spans/staging.h"
#include <assert.h>

//> Take the results of a batch
INLINED void take_results(const uint32_t width, const uint32_t *point,
                          const struct batch_result *result,
                          struct neighbor *const *to)
{
    for (uint32_t lane = 0; lane < width; lane++) {
        to[lane]->distance2 = result->distance2[lane];
        to[lane]->index = point[result->candidate[lane]];
    }
}
//<

//> Answer exactly what is not certified
static void answer_exactly(const struct scene *scene,
                           const struct batch_search *search,
                           const struct query_batch *batch,
                           uint32_t certified, struct counts *counts)
{
    for (uint32_t lane = 0; lane < batch->width; lane++)
        if (!(certified >> lane & 1)) {
            const uint32_t s = batch->begin + lane;
            search->exact(scene, search->context, s,
                          &search->results[search->inverse[s]], counts);
            counts->exact++;
        }
}
//<

//> Answer a whole batch exactly
static void answer_all_exactly(const struct scene *scene,
                               const struct batch_search *search,
                               const struct query_batch *batch,
                               struct counts *counts)
{
    const uint32_t *inverse = search->inverse + batch->begin;
    for (uint32_t lane = 0; lane < batch->width; lane++)
        search->results[inverse[lane]].index = NO_INDEX;
    answer_exactly(scene, search, batch, 0, counts);
}
//<

//> Answer a batch by a kernel
enum { ALL_LANES = (1 << BATCH) - 1 };

static void answer_batch(const struct scene *scene,
                         const struct staging *staging,
                         const struct batch_search *search,
                         const struct query_batch *batch,
                         struct counts *counts)
{
    const uint32_t *point = scene->sorted->cells.point;
    if (staging->reach > search->max_reach) {
        answer_all_exactly(scene, search, batch, counts);
        return;
    }
    struct neighbor *to[BATCH];
    //> Fetch the places of the results
    // They are seldom in a cache. Asked for before the kernel runs,
    // they are there when it is done. Whole batches, as kernels read
    // them.
    const uint32_t *inverse = search->inverse + batch->begin;
    for (int lane = 0; lane < BATCH; lane++) {
        to[lane] = search->results + inverse[lane];
        __builtin_prefetch(to[lane], 1);
    }
    //<
    struct batch_result result;
    uint32_t certified = search->kernel(scene, staging, batch, &result);
    if (batch->width == BATCH) // then the loop has no end to find
        take_results(BATCH, point, &result, to);
    else
        take_results(batch->width, point, &result, to);
    if (certified != ALL_LANES)
        answer_exactly(scene, search, batch, certified, counts);
}
//<

//> Answer the batches of a staging buffer
// Which is NULL where it could not be opened. A kernel reads whole
// batches, so the last few points of all are answered exactly, too.
static void answer_staged(const struct scene *scene,
                          const struct staging *staging,
                          const struct batch_search *searches,
                          int count, struct query_batch *batch,
                          struct counts *counts)
{
    const uint32_t n = scene->sorted->points.n;
    if (!staging || n - batch->begin < BATCH) {
        for (int k = 0; k < count; k++)
            answer_all_exactly(scene, &searches[k], batch, counts);
        return;
    }
    find_candidates(scene, staging, batch);
    uint32_t candidates = BATCH - batch->width;
    for (int r = 0; r < ROWS; r++)
        candidates += batch->to[r] - batch->from[r];
    for (int k = 0; k < count; k++)
        answer_batch(scene, staging, &searches[k], batch, counts);
    counts->distances += (uint64_t)candidates * BATCH * count;
}
//<

//> Stage for as many queries as fit
// For QUERIES, or for fewer where points crowd or the grid has few
// cells. Returns 0 if not even a batch can be staged.
static uint32_t stage_queries(const struct scene *scene, uint32_t row,
                              uint32_t begin, uint32_t left,
                              struct staging *staging)
{
    uint32_t width = left < QUERIES ? left : QUERIES;
    while (!stage_candidates(scene, row, begin, width, staging)) {
        if (width <= BATCH)
            return 0;
        width = width > 3 * BATCH ? 3 * BATCH : BATCH;
    }
    return width;
}
//<

//> Walk along the rows
// A batch ends where its row ends.
void answer_chunk(const struct scene *scene,
                  const struct batch_search *searches, int count,
                  uint32_t begin, uint32_t end, struct counts *counts)
{
    const struct grid *grid = &scene->sorted->grid;
    const uint32_t *start = scene->sorted->cells.start;
    uint32_t row = axis_cell(&grid->y, scene->sorted->points.y[begin]);
    struct staging staging;
    double max_reach = INFINITY;
    for (int k = 0; k < count; k++)
        max_reach = MIN(max_reach, searches[k].max_reach);
    staging_prepare(&staging, max_reach);
    while (begin < end) {
        while (start[(row + 1) * grid->x.count] <= begin)
            row++;
        uint32_t stop = start[(row + 1) * grid->x.count];
        uint32_t left = (stop < end ? stop : end) - begin;
        //> Stage queries and answer their batches
        uint32_t staged =
            stage_queries(scene, row, begin, left, &staging);
        uint32_t width = staged ? staged : left < BATCH ? left : BATCH;
        struct query_batch batch = {
            .block.y = axis_range(&grid->y, row, row, 1)};
        for (stop = begin + width; begin < stop; begin += batch.width) {
            batch.begin = begin;
            batch.width = stop - begin < BATCH ? stop - begin : BATCH;
            answer_staged(scene, staged ? &staging : NULL, searches,
                          count, &batch, counts);
        }
        //<
    }
}
//<

//> Work through all chunks
void share_chunks(const struct question *question, chunk_function *work,
                  const void *context)
{
    const uint32_t n = question->points.n, chunks = (n - 1) / CHUNK + 1;
    //> Share out the chunks
    // A crowded cell is many chunks, for all threads. But a thread
    // takes some that follow each other, as long as there are plenty:
    // their results go to the same buckets.
    const uint32_t share = chunks / 4 / (uint32_t)question->threads;
    const int at_once = share < 1 ? 1 : share > 8 ? 8 : (int)share;
    //<
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic, at_once)
    for (uint32_t chunk = 0; chunk < chunks; chunk++) {
        struct counts counts = {0};
        uint32_t begin = chunk * CHUNK, left = n - begin;
        work(context, begin, begin + MIN(left, CHUNK), &counts);
        counts_add(question->counts, &counts);
    }
}
//<

//> Search all batches
struct searches {
    const struct scene *scene;
    const struct batch_search *searches;
    int count;
};

static void search_chunk(const void *context, uint32_t begin,
                         uint32_t end, struct counts *counts)
{
    const struct searches *all = context;
    answer_chunk(all->scene, all->searches, all->count, begin, end,
                 counts);
}

void answer_all(const struct question *question,
                const struct scene *scene,
                const struct batch_search *searches, int count)
{
    assert(question->points.n == scene->sorted->points.n &&
           "the question's points are sorted");
    const struct searches all = {scene, searches, count};
    share_chunks(question, search_chunk, &all);
}
//<

//> Restore the order of the input
void restore_order(const struct neighbor *results,
                   const uint32_t *permutation, uint32_t n, int threads,
                   uint32_t *index, double *distance2)
{
#pragma omp parallel for num_threads(threads)
    for (uint32_t i = 0; i < n; i++) {
        const struct neighbor result = results[permutation[i]];
        index[i] = result.index;
        distance2[i] = result.distance2;
    }
}
//<

//> Search, then restore order
void answer_in_order(const struct question *question,
                     const struct scene *scene,
                     const struct partition *partition,
                     struct workspace *workspace,
                     struct batch_search *searches, int count)
{
    assert(partition->inverse && "order can be restored");
    const uint32_t n = question->points.n;
    struct mark mark = workspace_mark(workspace);
    for (int k = 0; k < count; k++) {
        searches[k].inverse = partition->inverse;
        searches[k].results =
            workspace_take(workspace, n, sizeof *searches[k].results);
    }
    answer_all(question, scene, searches, count);
    for (int k = 0; k < count; k++)
        restore_order(searches[k].results, partition->permutation, n,
                      question->threads, searches[k].index,
                      searches[k].distance2);
    workspace_release(workspace, mark);
}
//<
//<
