//> Find neighbors in the k-d tree
// First to the side where the query is, then to the other, if that is
// within reach. The way to a node, squared, is a sum in the order of
// the coordinates, like a distance: as rounding never turns an order
// over, it is at most the distance to any point there.
#include "ch12-range-queries/kd_tree.h"
#include "common/min_max.h"

//> Hold a search in the tree
struct search {
    const struct kd_tree *tree;
    struct neighbor_query *query;
    double way[MAX_DIMENSIONS]; // along each coordinate, to the node
};

static double way2(const struct search *search)
{
    double sum = 0;
    for (int k = 0; k < search->tree->sorted.points.d; k++)
        sum += search->way[k] * search->way[k];
    return sum;
}
//<

//> Go to the nearer side first
static void visit(struct search *search, uint32_t node)
{
    const struct kd_tree *tree = search->tree;
    search->query->steps++;
    if (node >= tree->leaves) {
        const struct span span = kd_leaf(tree, node - tree->leaves);
        take_neighbors(&tree->sorted, span.begin, span.end,
                       search->query);
        return;
    }
    const int axis = tree->axis[node];
    const double x = search->query->at[axis];
    const double to_left = x - tree->left_high[node];
    const double to_right = tree->right_low[node] - x;
    const bool right = to_right < to_left;
    visit(search, 2 * node + right);
    const double before = search->way[axis];
    const double other = right ? to_left : to_right;
    search->way[axis] = MAX(before, other);
    if (way2(search) <= search->query->reach2)
        visit(search, 2 * node + !right);
    search->way[axis] = before;
}

void kd_neighbors(const struct kd_tree *tree,
                  struct neighbor_query *query)
{
    struct search search = {tree, query};
    for (int k = 0; k < tree->sorted.points.d; k++) {
        const double below = tree->range.low[k] - query->at[k];
        const double above = query->at[k] - tree->range.high[k];
        search.way[k] = MAX(MAX(below, above), 0);
    }
    if (way2(&search) <= query->reach2)
        visit(&search, 1);
}
//<
//<
