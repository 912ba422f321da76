//> Search row spans in plain C
// The kernels of span_kernels.h for any processor: a batch takes a step
// of eight lanes for each candidate, a single query one for each point.
#include "ch09-row-spans/span_kernels.h"
#include "ch09-row-spans/portable_batch.h"

//> Stage a part of a row
static void stage(const struct sorted *sorted,
                  const struct span_source *source, uint32_t place,
                  struct staging *staging)
{
    const struct points p = sorted->points;
    for (uint32_t s = source->begin; s < source->end; s++, place++) {
        staging->place_x[place] = (float)(p.x[s] - source->x);
        staging->place_y[place] = (float)(p.y[s] - source->y);
        staging->index[place] = s;
    }
}
//<

//> Measure what is near
static float near_measure(const struct scene *scene, float dx, float dy)
{
    (void)scene;
    return dx * dx + dy * dy;
}
//<

//> Certify the nearest
// A candidate is certain if no other of the block can be as near, and
// nothing outside of it.
INLINED uint32_t certify(const enum geometry geometry,
                         const struct scene *scene,
                         const struct staging *staging,
                         const struct query_batch *batch,
                         const struct best_two *two,
                         struct batch_result *result)
{
    const struct sorted *sorted = scene->sorted;
    const double *x = sorted->points.x, *y = sorted->points.y;
    const float slack = near_slack(staging);
    uint32_t certified = 0;
    for (int lane = 0; lane < BATCH; lane++) {
        //> Certify one lane
        uint32_t s = batch->begin + lane;
        uint32_t t = staging->index[place_of(two->best[lane])];
        double margin =
            block_margin(&sorted->grid, &batch->block, x[s], y[s]);
        double near2 =
            pair2(geometry, scene->space, x[t] - x[s], y[t] - y[s])
                .near2;
        result->candidate[lane] = t;
        result->distance2[lane] = near2;
        certified |= (uint32_t)(is_certain(two, lane, slack) &&
                                near2 < margin * margin)
                     << lane;
        //<
    }
    return certified;
}
//<

//> Find the nearest of a batch
static uint32_t nearest(const struct scene *scene,
                        const struct staging *staging,
                        const struct query_batch *batch,
                        struct batch_result *result)
{
    struct best_two two =
        sweep_plainly(near_measure, scene, staging, batch);
    return IN_GEOMETRY(scene->space, certify, scene, staging, batch,
                       &two, result);
}
//<

//> Compare a query with a row span
INLINED void compare_span(const enum geometry geometry,
                          const struct scene *scene, uint32_t begin,
                          uint32_t end, struct query *query)
{
    const struct points p = scene->sorted->points;
    const uint32_t *point = scene->sorted->cells.point;
    for (uint32_t s = begin; s < end; s++)
        compare(geometry, scene->space, p, s, point[s], query);
}

static void compare_with_span(const struct scene *scene, uint32_t begin,
                              uint32_t end, struct query *query)
{
    IN_GEOMETRY(scene->space, compare_span, scene, begin, end, query);
}
//<

const struct span_kernels portable_spans = {"portable", stage, nearest,
                                            compare_with_span};

//> Choose the kernels of the row spans
const struct span_kernels *span_kernels(void)
{
    static const struct span_kernels *const kernels[ISA_COUNT] =
        FOR_EACH_ISA(&portable_spans, &avx2_spans, &avx512_spans);
    return kernels[isa_chosen()];
}
//<
//<
