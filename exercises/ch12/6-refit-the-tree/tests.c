// Tests of the refit: both numbers of every node, against a look at all
// points below it, and how many coordinates were looked at.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

static double *x[2];
static uint8_t *axis;
static struct tree tree;
static uint64_t *looks;

double number_at(uint32_t place, int k)
{
    ++*looks;
    return x[k][place];
}

static void prepare(uint32_t n, uint32_t leaves, uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    for (int k = 0; k < 2; k++)
        x[k] = kit_input("the coordinates", n, sizeof *x[k]);
    axis = kit_input("the axes", leaves, sizeof *axis);
    tree = (struct tree){.n = n, .leaves = leaves, .axis = axis};
    tree.left_high =
        kit_output("left_high", leaves, sizeof *tree.left_high);
    tree.right_low =
        kit_output("right_low", leaves, sizeof *tree.right_low);
    looks = kit_output("the count", 1, sizeof *looks);
    for (uint32_t s = 0; s < n; s++)
        for (int k = 0; k < 2; k++)
            x[k][s] = random_normal(&random) - 3 * k;
    for (uint32_t node = 0; node < leaves; node++)
        axis[node] = random_bits(&random) % 2;
    kit_given("%u points in %u leaves", n, leaves);
}

// The least or the greatest of the points from one leaf to another.
static double extreme(uint32_t first, uint32_t last, int k,
                      bool greatest)
{
    const uint64_t n = tree.n;
    double best = greatest ? -INFINITY : INFINITY;
    for (uint64_t s = first * n / tree.leaves;
         s < last * n / tree.leaves; s++)
        best = greatest ? fmax(best, x[k][s]) : fmin(best, x[k][s]);
    return best;
}

static const char *cause_of(double found, uint32_t first, uint32_t last,
                            int k, bool greatest)
{
    if (found == extreme(first, last, !k, greatest))
        return "This is of the other axis.";
    if (found == extreme(first, last, k, !greatest))
        return "The greatest is wanted on the left, the least on the "
               "right.";
    return "Are both nodes below it in its box, with all their points?";
}

static void check(double found, uint32_t node, uint32_t first,
                  uint32_t last, bool greatest)
{
    const int k = axis[node];
    const double right = extreme(first, last, k, greatest);
    if (found != right)
        WRONG(.where = kit_text("node %u, %s", node,
                                greatest ? "left_high" : "right_low"),
              .expected = kit_text("%g", right),
              .found = kit_text("%g", found),
              .cause = cause_of(found, first, last, k, greatest));
}

static void ask(void)
{
    CALL(*looks = 0; STUDENT(refit)(&tree));
    for (uint32_t node = 1; node < tree.leaves; node++) {
        uint32_t first = node, count = 1;
        while (first < tree.leaves) {
            first *= 2;
            count *= 2;
        }
        first -= tree.leaves;
        check(tree.left_high[node], node, first, first + count / 2,
              true);
        check(tree.right_low[node], node, first + count / 2,
              first + count, false);
    }
}

static void small(uint64_t seed)
{
    for (uint32_t n = 2; n < 40; n++) {
        prepare(n, 2, seed + n);
        ask();
    }
}

static void large(uint64_t seed)
{
    prepare(1000, 64, seed);
    ask();
    prepare(777, 256, seed);
    ask();
}

static void count(uint64_t seed)
{
    prepare(20000, 4096, seed);
    ask();
    const double each = (double)*looks / tree.n;
    kit_bands(
        each, (struct kit_band[]){{2, 6}, {4, 3}, {0, 0}},
        (struct kit_fault){
            .expected = "each coordinate looked at once, 2 for a "
                        "point",
            .found = kit_text("%.1f", each),
            .cause = "A node can hand up the box of its points."});
}

const struct kit_test kit_tests[] = {
    {"small", 2, "a root and two leaves", small},
    {"large", 2, "many nodes, leaves of unequal size", large},
    {"count", 6, "each coordinate is looked at once", count},
    {0},
};
