// Boxes are handed up from the leaves.
#include "exercise.h"
//- solution
#include <math.h>

struct box {
    double low[2], high[2];
};

static struct box box_of_leaf(const struct tree *tree, uint32_t leaf)
{
    const uint64_t n = tree->n;
    struct box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    for (uint32_t s = (uint32_t)(leaf * n / tree->leaves);
         s < (leaf + 1) * n / tree->leaves; s++)
        for (int axis = 0; axis < 2; axis++) {
            const double number = number_at(s, axis);
            box.low[axis] = fmin(box.low[axis], number);
            box.high[axis] = fmax(box.high[axis], number);
        }
    return box;
}

static struct box refit_node(const struct tree *tree, uint32_t node)
{
    if (node >= tree->leaves)
        return box_of_leaf(tree, node - tree->leaves);
    struct box left = refit_node(tree, 2 * node);
    const struct box right = refit_node(tree, 2 * node + 1);
    tree->left_high[node] = left.high[tree->axis[node]];
    tree->right_low[node] = right.low[tree->axis[node]];
    for (int axis = 0; axis < 2; axis++) {
        left.low[axis] = fmin(left.low[axis], right.low[axis]);
        left.high[axis] = fmax(left.high[axis], right.high[axis]);
    }
    return left;
}
//- starter
//- end

void refit(const struct tree *tree)
{
    //- solution
    refit_node(tree, 1);
    //- starter
    // // Your turn: so far all numbers are 0.
    // for (uint32_t node = 1; node < tree->leaves; node++)
    //     tree->left_high[node] = tree->right_low[node] = 0;
    //- end
}
