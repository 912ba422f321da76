//> Query the orthotree
// Bins are compared, whole numbers, and no coordinates of borders: a
// node beyond the bins of the range's borders is outside, one strictly
// between them inside.
#include "ch12-range-queries/orthotree.h"

//> Hold a query in bins
struct bin_query {
    const struct orthotree *tree;
    const struct range *range;
    struct report *report;
    // Nodes from inner to end - 1 along a coordinate lie inside.
    uint32_t first[MAX_DIMENSIONS], last[MAX_DIMENSIONS];
    uint64_t inner[MAX_DIMENSIONS], end[MAX_DIMENSIONS];
};

struct corner {
    uint32_t bin[MAX_DIMENSIONS]; // the lowest of a node
};
//<

//> Turn the range into bins
static struct bin_query query_of(const struct orthotree *tree,
                                 const struct range *range,
                                 struct report *report)
{
    struct bin_query query = {tree, range, report};
    for (int k = 0; k < tree->sorted.points.d; k++) {
        query.first[k] = bin_along(tree, k, range->low[k]);
        query.last[k] = bin_along(tree, k, range->high[k]);
        query.inner[k] = (uint64_t)query.first[k] +
                         (range->low[k] > tree->range.low[k]);
        query.end[k] = (uint64_t)query.last[k] +
                       (range->high[k] >= tree->range.high[k]);
    }
    return query;
}
//<

//> Go down some levels
// To the node in which a Morton number is.
static void go_down(const struct orthotree *tree, uint64_t key,
                    int level, int to, struct corner *corner)
{
    for (; level < to; level++) {
        const uint32_t child = child_of(tree, key, level);
        const int below = tree->levels - 1 - level;
        for (int k = 0; k < tree->sorted.points.d; k++)
            corner->bin[k] |= (child >> k & 1) << below;
    }
}
//<

//> Compare a node with the range
// Returns false if it lies outside. Else axes becomes the set of
// coordinates along which its points may lie inside or outside.
static bool meets(const struct bin_query *query,
                  const struct corner *corner, int level,
                  unsigned *axes)
{
    const struct orthotree *tree = query->tree;
    const uint64_t side = (uint64_t)1 << (tree->levels - level);
    *axes = 0;
    for (int k = 0; k < tree->sorted.points.d; k++) {
        const uint64_t low = corner->bin[k], high = low + side - 1;
        if (high < query->first[k] || low > query->last[k])
            return false;
        const bool inside =
            query->inner[k] <= low && high < query->end[k];
        *axes |= (unsigned)!inside << k;
    }
    return true;
}
//<

//> Visit the children that the range meets
static void visit(const struct bin_query *query, uint32_t number,
                  struct corner corner, int level)
{
    const struct orthotree *tree = query->tree;
    const struct ortho_node *node = &tree->node[number];
    unsigned axes;
    if (node->begin == node->end)
        return;
    query->report->steps++;
    go_down(tree, node->key, level, node->level, &corner);
    if (!meets(query, &corner, node->level, &axes))
        return;
    if (axes == 0)
        report_all(&tree->sorted, node->begin, node->end,
                   query->report);
    else if (node->children == 0)
        report_inside(&tree->sorted, node->begin, node->end,
                      (struct filter){query->range, axes},
                      query->report);
    else
        for (uint32_t child = 0; child < node->children; child++)
            visit(query, node->first_child + child, corner,
                  node->level);
}

void ortho_query(const struct orthotree *tree,
                 const struct range *range, struct report *report)
{
    const struct bin_query query = query_of(tree, range, report);
    const int d = tree->sorted.points.d;
    if (ranges_meet(&tree->range, range, d))
        visit(&query, 0, (struct corner){0}, 0);
}
//<
//<
