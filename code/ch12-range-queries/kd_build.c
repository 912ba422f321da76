//> Build the k-d tree
// Level by level the points are copied from one of two sets of arrays
// to the other, the lower half of each node in front. n log n steps;
// 16 d + 40 bytes a point while it is built.
#include "ch12-range-queries/kd_tree.h"
#include "ch12-range-queries/select.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include <math.h>
#include <stdlib.h>

//> Hold what is being built
struct building {
    struct kd_tree *tree;
    struct sorted_points side[2]; // the first is the tree's own
    double *room;                 // 2 n, for medians
    uint32_t *place;              // n: where each point goes
};

// Where the points are before the nodes of a level cut them.
static const struct sorted_points *from_side(const struct building *b,
                                             int level)
{
    return &b->side[(b->tree->depth - level) % 2];
}
//<

//> Choose the coordinate with the largest spread
static int widest(const struct point_set *points, struct span span)
{
    const struct range range = range_of(points, span.begin, span.end);
    int axis = 0;
    double max_spread = -1;
    for (int k = 0; k < points->d; k++) {
        const double spread = range.high[k] / 2 - range.low[k] / 2;
        if (spread > max_spread) {
            max_spread = spread;
            axis = k;
        }
    }
    return axis;
}
//<

//> Say where each point goes
// The numbers below the median go left, and of those that are equal so
// many as have room there. Returns the greatest that goes left.
static double place_halves(const double *x, struct span span,
                           uint32_t middle, double median,
                           uint32_t *place)
{
    //> Count those that are equal and may still go left
    uint32_t below = 0;
    for (uint32_t i = span.begin; i < span.end; i++)
        below += x[i] < median;
    uint32_t equal = middle - span.begin - below;
    //<
    uint32_t left = span.begin, right = middle;
    double left_max = -INFINITY;
    for (uint32_t i = span.begin; i < span.end; i++) {
        const bool same = (x[i] == median) & (equal > 0);
        const bool first = (x[i] < median) | same;
        place[i] = first ? left : right;
        equal -= same;
        left += first;
        right += !first;
        const double value = first ? x[i] : left_max;
        left_max = MAX(value, left_max);
    }
    return left_max;
}
//<

//> Copy the halves
static void copy_halves(const struct sorted_points *from,
                        struct span span, const uint32_t *place,
                        const struct sorted_points *to)
{
    for (int k = 0; k < from->points.d; k++) {
        const double *x = from->points.x[k];
        double *sorted = to->points.x[k];
        for (uint32_t i = span.begin; i < span.end; i++)
            sorted[place[i]] = x[i];
    }
    for (uint32_t i = span.begin; i < span.end; i++)
        to->index[place[i]] = from->index[i];
}
//<

//> Find the places below a node
static struct span span_of(const struct kd_tree *tree, uint32_t node,
                           int level)
{
    const int height = tree->depth - level;
    const uint32_t first = (node << height) - tree->leaves;
    const uint32_t last = first + (1u << height) - 1;
    return (struct span){kd_leaf(tree, first).begin,
                         kd_leaf(tree, last).end};
}
//<

//> Cut a node at the median
static void cut(const struct building *b, uint32_t node, int level)
{
    struct kd_tree *tree = b->tree;
    if (level == tree->depth)
        return;
    const struct sorted_points *from = from_side(b, level);
    const struct span span = span_of(tree, node, level);
    const uint32_t middle = span_of(tree, 2 * node, level + 1).end;
    //> Choose, select, place and copy
    const int axis = widest(&from->points, span);
    const double *x = from->points.x[axis];
    const double median = select_rank(
        x + span.begin, span.end - span.begin, middle - span.begin,
        b->room + 2 * (size_t)span.begin);
    tree->axis[node] = (uint8_t)axis;
    tree->right_low[node] = median;
    tree->left_high[node] =
        place_halves(x, span, middle, median, b->place);
    copy_halves(from, span, b->place, from_side(b, level + 1));
    //<
    //> Cut both halves, one of them as a task
    enum { WORTH_A_TASK = 1 << 13 };
#pragma omp task if (span.end - span.begin > WORTH_A_TASK)
    cut(b, 2 * node, level + 1);
    cut(b, 2 * node + 1, level + 1);
#pragma omp taskwait
    //<
}
//<

//> Build from points in any order
// They are in the side where the root expects them.
static void build(struct kd_tree *tree, struct sorted_points other)
{
    const uint32_t n = tree->sorted.points.n;
    struct building b = {tree,
                         {tree->sorted, other},
                         allocate(2 * (size_t)n, sizeof(double)),
                         allocate(n, sizeof(uint32_t))};
    tree->range = range_of(&from_side(&b, 0)->points, 0, n);
#pragma omp parallel num_threads(tree->threads) if (tree->threads > 1)
#pragma omp single
    cut(&b, 1, 0);
    free(b.room);
    free(b.place);
}
//<

//> Make the k-d tree
struct kd_tree kd_make(const struct point_set *points,
                       uint32_t leaf_size, int threads)
{
    const uint32_t n = points->n;
    struct kd_tree tree = {sorted_points_allocate(n, points->d),
                           .threads = threads};
    //> Choose the depth and make room for the nodes
    while ((n - 1) >> tree.depth >= leaf_size)
        tree.depth++;
    tree.leaves = 1u << tree.depth;
    tree.axis = allocate(tree.leaves, sizeof *tree.axis);
    tree.left_high = allocate(tree.leaves, sizeof *tree.left_high);
    tree.right_low = allocate(tree.leaves, sizeof *tree.right_low);
    //<
    struct sorted_points other = sorted_points_allocate(n, points->d);
    struct sorted_points *first =
        tree.depth % 2 ? &other : &tree.sorted;
    for (uint32_t i = 0; i < n; i++)
        first->index[i] = i;
    sorted_points_fill(first, points);
    build(&tree, other);
    sorted_points_free(&other);
    return tree;
}
//<

void kd_free(struct kd_tree *tree)
{
    sorted_points_free(&tree->sorted);
    free(tree->axis);
    free(tree->left_high);
    free(tree->right_low);
}

size_t kd_bytes(const struct kd_tree *tree)
{
    return sorted_points_bytes(&tree->sorted) +
           tree->leaves * (2 * sizeof(double) + 1);
}

//> Build anew from the last order
void kd_rebuild(struct kd_tree *tree, const struct point_set *points)
{
    struct sorted_points other =
        sorted_points_allocate(points->n, points->d);
    struct sorted_points *first =
        tree->depth % 2 ? &other : &tree->sorted;
    for (uint32_t s = 0; s < points->n; s++)
        first->index[s] = tree->sorted.index[s];
    sorted_points_fill(first, points);
    build(tree, other);
    sorted_points_free(&other);
}
//<

//> Find the range around both
static struct range join(const struct range *a, const struct range *b,
                         int d)
{
    struct range both = *a;
    for (int k = 0; k < d; k++) {
        both.low[k] = MIN(b->low[k], a->low[k]);
        both.high[k] = MAX(b->high[k], a->high[k]);
    }
    return both;
}
//<

//> Refit the bounds
static struct range refit(struct kd_tree *tree, uint32_t node)
{
    if (node >= tree->leaves) {
        const struct span span = kd_leaf(tree, node - tree->leaves);
        return range_of(&tree->sorted.points, span.begin, span.end);
    }
    const struct range left = refit(tree, 2 * node);
    const struct range right = refit(tree, 2 * node + 1);
    tree->left_high[node] = left.high[tree->axis[node]];
    tree->right_low[node] = right.low[tree->axis[node]];
    return join(&left, &right, tree->sorted.points.d);
}

void kd_refit(struct kd_tree *tree, const struct point_set *points)
{
    sorted_points_fill(&tree->sorted, points);
    tree->range = refit(tree, 1);
}
//<
//<
