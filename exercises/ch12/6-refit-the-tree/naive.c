// Each node looks at all points below it.
// expect: 4 of 10
#include "exercise.h"
#include <math.h>

void refit(const struct tree *tree)
{
    const uint64_t n = tree->n;
    for (uint32_t node = 1; node < tree->leaves; node++) {
        uint32_t first = node, count = 1;
        while (first < tree->leaves) {
            first *= 2;
            count *= 2;
        }
        first -= tree->leaves;
        const uint32_t begin = (uint32_t)(first * n / tree->leaves);
        const uint32_t middle =
            (uint32_t)((first + count / 2) * n / tree->leaves);
        const uint32_t end =
            (uint32_t)((first + count) * n / tree->leaves);
        tree->left_high[node] = -INFINITY;
        tree->right_low[node] = INFINITY;
        for (uint32_t s = begin; s < end; s++) {
            const double number = number_at(s, tree->axis[node]);
            if (s < middle)
                tree->left_high[node] =
                    fmax(tree->left_high[node], number);
            else
                tree->right_low[node] =
                    fmin(tree->right_low[node], number);
        }
    }
}
