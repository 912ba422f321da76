// Rows of numbers become points, an array for each coordinate. Queries
// stay rows, since each of them is read as a whole.
#include "range/input.h"
#include "ch12-range-queries/generate_set.h"
#include "common/allocate.h"
#include "near/progress.h"
#include "range/rows.h"
#include <stdlib.h>

enum { USUAL_DIMENSIONS = 3, USUAL_BOXES = 1000 };

struct point_set get_point_set(const struct options *options)
{
    struct point_set points;
    const int d = options->dimensions;
    progress_start(options->file ? "reading" : "drawing points", 0);
    if (options->file) {
        struct rows rows = read_rows(options->file, 0, MAX_DIMENSIONS);
        points = point_set_allocate(rows.count, rows.columns);
        for (int k = 0; k < points.d; k++)
            for (uint32_t i = 0; i < points.n; i++)
                points.x[k][i] =
                    rows.value[(size_t)i * rows.columns + k];
        free(rows.value);
    } else {
        points = generate_set(options->distribution, options->n,
                              d ? d : USUAL_DIMENSIONS, options->seed);
    }
    progress_stop();
    return points;
}

static struct queries draw_queries(const struct options *options,
                                   const struct point_set *points)
{
    const int d = points->d;
    const bool boxes = options->question == BOXES;
    struct queries queries = {options->random ? options->random
                                              : USUAL_BOXES,
                              boxes ? 2 * d : d};
    const struct range all = range_of(points, 0, points->n);
    struct random random = {options->seed + 0x5eed};
    queries.value = allocate((size_t)queries.count * queries.columns,
                             sizeof *queries.value);
    for (uint32_t q = 0; q < queries.count; q++) {
        const struct range range =
            random_range(&all, d, boxes ? options->share : 0, &random);
        double *row = queries.value + (size_t)q * queries.columns;
        for (int k = 0; k < d; k++) {
            row[k] = range.low[k];
            if (boxes)
                row[d + k] = range.high[k];
        }
    }
    return queries;
}

struct queries get_queries(const struct options *options,
                           const struct point_set *points)
{
    const bool boxes = options->question == BOXES;
    const int columns = boxes ? 2 * points->d : points->d;
    if (options->queries) {
        const struct rows rows =
            read_rows(options->queries, columns, columns);
        return (struct queries){rows.count, columns, rows.value};
    }
    if (boxes || options->random)
        return draw_queries(options, points);
    return (struct queries){points->n, columns, NULL};
}
