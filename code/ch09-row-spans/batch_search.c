//> Drive the batch search
// Rows of cells, staging buffers, batches, searches: four loops. A
// staging buffer serves five batches, or where points crowd three or
// one; where even that is too many, every query is answered exactly.
#include "ch09-row-spans/batch_search.h"
#include "ch09-row-spans/staging.h"
#include <assert.h>
#include <stddef.h>

//> Hold the places of the results
struct targets {
    struct neighbor *of[BATCH];
};
//<

//> Fetch the places of the results
// They are seldom in a cache. Asked for before the kernel runs, they
// are there when it is done. Whole batches, as kernels read them.
static struct targets fetch_results(const struct batch_search *search,
                                    const struct query_batch *batch)
{
    const uint32_t *inverse = search->inverse + batch->begin;
    struct neighbor *results = search->results;
    struct targets to;
    for (int lane = 0; lane < BATCH; lane++) {
        to.of[lane] = results + inverse[lane];
        __builtin_prefetch(to.of[lane], 1);
    }
    return to;
}
//<

//> Take the results of a batch
INLINED void take_results(const uint32_t width, const uint32_t *point,
                          const struct batch_result *result,
                          const struct targets *to)
{
    for (uint32_t lane = 0; lane < width; lane++) {
        to->of[lane]->distance2 = result->distance2[lane];
        to->of[lane]->index = point[result->candidate[lane]];
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
            counts->tasks++;
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
    const struct targets to = fetch_results(search, batch);
    struct batch_result result;
    uint32_t certified = search->kernel(scene, staging, batch, &result);
    if (batch->width == BATCH) // then the loop has no end to find
        take_results(BATCH, point, &result, &to);
    else
        take_results(batch->width, point, &result, &to);
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
    staging_point_out(scene, staging, batch);
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
    while (!staging_open(scene, row, begin, width, staging)) {
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

//> Share out the chunks
// A crowded cell is many chunks, for all threads. But a thread takes
// some that follow each other, as long as there are plenty: their
// results go to the same buckets.
static int chunks_at_once(uint32_t chunks, int threads)
{
    uint32_t share = chunks / 16 / (uint32_t)threads;
    return share < 1 ? 1 : share > 8 ? 8 : (int)share;
}
//<

//> Work through all chunks
void share_chunks(const struct question *question, chunk_function *work,
                  const void *context)
{
    const uint32_t n = question->points.n, chunks = (n - 1) / CHUNK + 1;
    const int threads = question->threads;
#pragma omp parallel for num_threads(threads) \
    schedule(dynamic, chunks_at_once(chunks, threads))
    for (uint32_t chunk = 0; chunk < chunks; chunk++) {
        struct counts counts = {0};
        uint32_t begin = chunk * CHUNK, left = n - begin;
        work(context, begin, begin + (left < CHUNK ? left : CHUNK),
             &counts);
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
//<
