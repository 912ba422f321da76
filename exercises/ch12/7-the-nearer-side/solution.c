// The way to a node, along both coordinates, bounds what is below.
#include "exercise.h"
#include <math.h>

//- solution
struct search {
    const struct tree *tree;
    const double *place;
    double way[2], best2;
};

static void visit(struct search *search, uint32_t node)
{
    const struct tree *tree = search->tree;
    if (node >= tree->leaves) {
        search->best2 =
            fmin(search->best2, measure_leaf(node - tree->leaves));
        return;
    }
    const int axis = tree->axis[node];
    const double x = search->place[axis];
    const double to_left = x - tree->left_high[node];
    const double to_right = tree->right_low[node] - x;
    const int right = to_right < to_left;
    visit(search, 2 * node + right);
    const double before = search->way[axis];
    search->way[axis] = fmax(before, right ? to_left : to_right);
    if (search->way[0] * search->way[0] +
            search->way[1] * search->way[1] <
        search->best2)
        visit(search, 2 * node + !right);
    search->way[axis] = before;
}
//- starter
//- end

double nearest2(const struct tree *tree, const double place[2])
{
    //- solution
    struct search search = {tree, place, {0, 0}, INFINITY};
    visit(&search, 1);
    return search.best2;
    //- starter
    // // Your turn: so far it measures the leaf where the place is.
    // uint32_t node = 1;
    // while (node < tree->leaves)
    //     node = 2 * node +
    //            (place[tree->axis[node]] >= tree->right_low[node]);
    // return fmax(measure_leaf(node - tree->leaves), 0);
    //- end
}
