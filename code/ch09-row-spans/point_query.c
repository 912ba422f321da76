//> Answer one query exactly
// Row by row, pruned, in blocks of doubled radius. About 100 distances
// where points are spread evenly; as many as a crowded block has. Ties
// go to the lowest index.
#include "ch09-row-spans/point_query.h"
#include "ch09-row-spans/span_kernels.h"

//> Compare with a row of the block
// Which with wraparound may go over the seam, and is two spans then.
void compare_row(const struct scene *scene,
                 const struct axis_range *range, uint32_t row,
                 struct query *query)
{
    const struct sorted *sorted = scene->sorted;
    const uint32_t columns = sorted->grid.x.count;
    const uint32_t *start = sorted->cells.start + row * columns;
    const uint32_t end = range->first + range->count;
    uint32_t begin = start[range->first];
    uint32_t stop = start[end < columns ? end : columns];
    scene->kernels->compare(scene, begin, stop, query);
    query->compared += stop - begin;
    //> Go on at the first column
    if (end > columns) {
        stop = start[end - columns];
        scene->kernels->compare(scene, start[0], stop, query);
        query->compared += stop - start[0];
    }
    //<
}
//<

//> Prune a row
bool prune_row(const struct scene *scene, uint32_t row,
               const struct query *query)
{
    const struct axis *axis = &scene->sorted->grid.y;
    const double above = axis->border[row] - query->y;
    const double below = query->y - axis->border[row + 1];
    double gap = MAX(below, above);
    //> Try the other way round
    if (scene->space.geometry == WRAPAROUND)
        gap = MIN(gap, axis->period - MAX(-below, -above));
    //<
    return gap > 0 && gap * gap > query->best2;
}
//<

//> Answer a point query
struct query nearest_query(const struct scene *scene, uint32_t s)
{
    const struct grid *grid = &scene->sorted->grid;
    struct query query = query_of(scene->sorted, s);
    const uint32_t own = axis_cell(&grid->y, query.y);
    for (uint32_t radius = 1;; radius *= 2) {
        struct block block = block_of(grid, query.x, query.y, radius);
        compare_row(scene, &block.x, own, &query);
        for (uint32_t k = 0; k < block.y.count; k++) {
            uint32_t row = range_cell(&grid->y, &block.y, k);
            if (row != own && !prune_row(scene, row, &query))
                compare_row(scene, &block.x, row, &query);
        }
        double margin = block_margin(grid, &block, query.x, query.y);
        if (query.best2 < margin * margin || block_covers(grid, &block))
            return query;
    }
}
//<
//<
