// Two questions about the last bit, answered by counting over all pairs
// of points: how many distances change when a product and a sum are
// contracted to one operation, and how many squared distances have the
// same square root as the next larger double.
//     rounding [POINTS]
#include "common/experiment.h"

//> Contract the distance
static double contracted2(double dx, double dy)
{
    return fma(dx, dx, dy * dy);
}
//<

//> Ask whether the root can tell
static int root_is_blind(double d2)
{
    return sqrt(d2) == sqrt(nextafter(d2, INFINITY));
}
//<

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000, 2, MANY);
    const struct points points =
        uniform_question(STANDARD, n, 1).points;

    uint64_t all = 0, contracted = 0, blind = 0;
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i + 1; j < n; j++) {
            double dx = points.x[i] - points.x[j];
            double dy = points.y[i] - points.y[j];
            double d2 = distance2(dx, dy);
            all++;
            contracted += contracted2(dx, dy) != d2;
            blind += root_is_blind(d2);
        }
    print_header(&e, "name pairs");
    row("all\t%ju", (uintmax_t)all);
    row("contracted\t%ju", (uintmax_t)contracted);
    row("blind\t%ju", (uintmax_t)blind);
}
