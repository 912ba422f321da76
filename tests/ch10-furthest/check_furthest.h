// The check of chapter 10's kernels, for one instruction set: whatever
// a kernel certifies is what the plainest search finds, and of evenly
// spread points it certifies nearly all. For tests/instructions, too.
#pragma once
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/span_kernels.h"
#include "ch10-furthest/furthest_kernels.h"
#include "common/generate.h"
#include "harness.h"

// Leaves what is not certified.
static inline void leave_furthest(const struct scene *scene,
                                  const void *context, uint32_t s,
                                  struct neighbor *found,
                                  struct counts *counts)
{
    (void)scene, (void)context, (void)s, (void)counts;
    found->index = NO_INDEX;
}

// Returns how many points had their furthest certified.
static inline uint32_t check_certified(batch_kernel *kernel,
                                       const struct span_kernels *spans,
                                       const struct question *question,
                                       double c)
{
    const uint32_t n = question->points.n;
    struct workspace workspace = {0};
    struct partition partition =
        partition_make(question, c, RESTORE, &workspace);
    const struct scene scene = {question->space, &partition.sorted,
                                spans};
    const uint32_t *point = partition.sorted.cells.point;
    const uint32_t *at = partition.inverse;
    struct neighbor *found =
        workspace_take(&workspace, n, sizeof *found);
    const struct batch_search search = {
        .kernel = kernel,
        .max_reach = furthest_max_reach(question->space),
        .exact = leave_furthest,
        .results = found,
        .inverse = partition.inverse};
    struct answers right = answers_allocate(n);
    struct counts counts = {0};
    uint32_t certified = 0;
    search_plainly(question, &right);
    answer_chunk(&scene, &search, 1, 0, n, &counts);
    for (uint32_t s = 0; s < n; s++) {
        if (found[at[s]].index == NO_INDEX)
            continue;
        certified++;
        CHECK_INT(right.furthest[point[s]], found[at[s]].index,
                  "%s: furthest of %u, %g in a cell", spans->name,
                  point[s], c);
        CHECK_DOUBLE(right.furthest2[point[s]], found[at[s]].distance2,
                     "%s: distance of %u, %g in a cell", spans->name,
                     point[s], c);
    }
    answers_free(&right);
    workspace_free(&workspace);
    return certified;
}

static inline void check_furthest(batch_kernel *kernel,
                                  const struct span_kernels *spans)
{
    static const double c[] = {0.3, 1.5, 2, 6};
    for (int d = 0; d < distribution_count; d++)
        for (int k = 0; k < 4; k++) {
            const uint32_t n = d == 0 ? 2500 : 800;
            test_seed(k);
            struct points points = generate(&distributions[d], n, k);
            double x0 = 0, x1 = 1, y0 = 0, y1 = 1;
            for (uint32_t i = 0; i < n; i++) {
                x0 = fmin(x0, points.x[i]), x1 = fmax(x1, points.x[i]);
                y0 = fmin(y0, points.y[i]), y1 = fmax(y1, points.y[i]);
            }
            struct question question = {
                points, {WRAPAROUND, x1 - x0, y1 - y0}, 1};
            uint32_t certified =
                check_certified(kernel, spans, &question, c[k]);
            if (d == 0 && k == 2)
                CHECK(certified > 0.95 * n, "%s: certified %u of %u",
                      spans->name, certified, n);
            points_free(&points);
        }
}
