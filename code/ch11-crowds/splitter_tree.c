//> Make the splitter tree
// A sample, cut in halves down to the leaves; then all points walk down
// the tree in step, level by level, as vectors do.
#include "ch11-crowds/splitter_tree.h"
#include "common/min_max.h"
#include "common/random.h"
#include <math.h>

//> Draw a sample
static struct point_record *draw(struct points points, uint32_t count,
                                 struct workspace *workspace)
{
    struct random random = {points.n};
    struct point_record *sample =
        workspace_take(workspace, count, sizeof *sample);
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t i = random_bits(&random) % points.n;
        sample[k] =
            (struct point_record){points.x[i], points.y[i], 0, i};
    }
    return sample;
}
//<

//> Cut the sample
//> Take a side of a region
// Where nothing is cut, at -INFINITY, the second side is all of it.
static struct box side_of(struct box region, struct cut cut,
                          bool second)
{
    double *edge = second ? (cut.by_y ? &region.bottom : &region.left)
                          : (cut.by_y ? &region.top : &region.right);
    *edge = second ? MAX(*edge, cut.at) : MIN(*edge, cut.at);
    return region;
}
//<

struct cutting {
    const struct point_record *sample;
    struct splitter_tree *tree;
    struct cut_room room;
};

// Where the sample is in one place, or there is none, all go to the
// second side.
static void cut_sample(const struct cutting *cutting, uint32_t node,
                       uint32_t *list, uint32_t n, struct box region)
{
    struct splitter_tree *tree = cutting->tree;
    if (node >= tree->leaves - 1) {
        tree->region[node - (tree->leaves - 1)] = region;
        return;
    }
    const struct box box = box_of(cutting->sample, list, n);
    struct cut cut = {false, -INFINITY};
    uint32_t first = 0;
    if (n > 0 && !box_is_place(&box))
        first = cut_list(cutting->sample, list, n, &box, cutting->room,
                         &cut);
    tree->x[node] = cut.by_y ? -INFINITY : cut.at;
    tree->y[node] = cut.by_y ? cut.at : -INFINITY;
    cut_sample(cutting, 2 * node + 1, list, first,
               side_of(region, cut, false));
    cut_sample(cutting, 2 * node + 2, list + first, n - first,
               side_of(region, cut, true));
}
//<

struct splitter_tree splitter_tree_make(struct points points,
                                        uint32_t per_piece,
                                        struct workspace *workspace)
{
    struct splitter_tree tree = {0};
    while (tree.depth < DEEPEST_LEAF &&
           points.n >> tree.depth > per_piece)
        tree.depth++;
    tree.leaves = 1u << tree.depth;
    tree.x = workspace_take(workspace, tree.leaves, sizeof *tree.x);
    tree.y = workspace_take(workspace, tree.leaves, sizeof *tree.y);
    tree.region =
        workspace_take(workspace, tree.leaves, sizeof *tree.region);
    struct mark mark = workspace_mark(workspace);
    const uint32_t n = tree.leaves * SAMPLE_PER_LEAF;
    const struct cutting cutting = {
        draw(points, n, workspace),
        &tree,
        {workspace_take(workspace, n, sizeof(double)),
         workspace_take(workspace, n, sizeof(uint32_t))}};
    uint32_t *list = workspace_take(workspace, n, sizeof *list);
    for (uint32_t k = 0; k < n; k++)
        list[k] = k;
    cut_sample(&cutting, 0, list, n,
               (struct box){-INFINITY, INFINITY, -INFINITY, INFINITY});
    workspace_release(workspace, mark);
    return tree;
}

//> Walk down the tree in step
void splitter_tree_find(const struct splitter_tree *tree,
                        const double *x, const double *y,
                        uint32_t count, uint32_t *leaf)
{
    const double *cut_x = tree->x, *cut_y = tree->y;
    for (uint32_t k = 0; k < count; k++)
        leaf[k] = 0;
    for (uint32_t level = 0; level < tree->depth; level++)
        for (uint32_t k = 0; k < count; k++) {
            const uint32_t node = leaf[k];
            const uint32_t second =
                (x[k] >= cut_x[node]) & (y[k] >= cut_y[node]);
            leaf[k] = 2 * node + 1 + second;
        }
    for (uint32_t k = 0; k < count; k++)
        leaf[k] -= tree->leaves - 1;
}
//<
//<
