//> Query the k-d tree
// Down from the root, where the range may be. A side of the range that
// a node lies within is tested no more below it; where no side is left,
// all points are reported, and none is looked at.
#include "ch12-range-queries/kd_tree.h"
#include "common/min_max.h"
#include <string.h>

//> Hold a range query
// Bit 2 k of a set of sides: points may lie below low[k]; bit 2 k + 1:
// above high[k].
struct range_query {
    const struct kd_tree *tree;
    const struct range *range;
    struct report *report;
};
//<

//> Say which borders matter
static unsigned sides_outside(const struct range *inner,
                              const struct range *range, int d)
{
    unsigned sides = 0;
    for (int k = 0; k < d; k++) {
        sides |= (unsigned)(inner->low[k] < range->low[k]) << 2 * k;
        sides |= (unsigned)(inner->high[k] > range->high[k])
                 << (2 * k + 1);
    }
    return sides;
}

static unsigned axes_of(unsigned sides)
{
    unsigned axes = 0;
    for (int k = 0; sides >> 2 * k; k++)
        axes |= (unsigned)((sides >> 2 * k & 3) != 0) << k;
    return axes;
}
//<

//> Report what is below a node
static void report_node(const struct range_query *query, uint32_t node)
{
    const struct kd_tree *tree = query->tree;
    uint32_t first = node, last = node;
    while (first < tree->leaves) {
        first = 2 * first;
        last = 2 * last + 1;
    }
    report_all(&tree->sorted, kd_leaf(tree, first - tree->leaves).begin,
               kd_leaf(tree, last - tree->leaves).end, query->report);
}
//<

//> Go down where the range may be
static void visit(const struct range_query *query, uint32_t node,
                  unsigned sides)
{
    const struct kd_tree *tree = query->tree;
    query->report->steps++;
    if (sides == 0) {
        report_node(query, node);
        return;
    }
    if (node >= tree->leaves) {
        const struct span span = kd_leaf(tree, node - tree->leaves);
        report_inside(&tree->sorted, span.begin, span.end,
                      (struct filter){query->range, axes_of(sides)},
                      query->report);
        return;
    }
    const int axis = tree->axis[node];
    const double low = query->range->low[axis];
    const double high = query->range->high[axis];
    const unsigned below = 1u << 2 * axis, above = 2 * below;
    if (low <= tree->left_high[node])
        visit(query, 2 * node,
              tree->left_high[node] <= high ? sides & ~above : sides);
    if (high >= tree->right_low[node])
        visit(query, 2 * node + 1,
              tree->right_low[node] >= low ? sides & ~below : sides);
}

void kd_query(const struct kd_tree *tree, const struct range *range,
              struct report *report)
{
    const int d = tree->sorted.points.d;
    const struct range_query query = {tree, range, report};
    if (ranges_meet(&tree->range, range, d))
        visit(&query, 1, sides_outside(&tree->range, range, d));
}
//<
//<
