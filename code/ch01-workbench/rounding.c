//> Count what rounding does
// Two questions about the last bit, answered by counting: how many
// distances change when the compiler contracts a product and a sum to
// one operation, and how many different squared distances have the same
// square root.
//
//     rounding [POINTS]
#include "common/fail.h"
#include "common/generate.h"
#include "common/geometry.h"
#include "common/report.h"
#include <stdio.h>
#include <stdlib.h>

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int main(int argc, char **argv)
{
    fail_as("rounding", NULL);
    uint32_t n = argc > 1 ? atoi(argv[1]) : 2000;
    size_t pairs = (size_t)n * (n - 1) / 2, pair = 0;
    struct points points = generate(find_distribution("uniform"), n, 1);
    double *distances = allocate(pairs, sizeof *distances);

    //> Compare with the contracted distance
    size_t contracted = 0;
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i + 1; j < n; j++) {
            double dx = points.x[i] - points.x[j];
            double dy = points.y[i] - points.y[j];
            distances[pair++] = distance2(dx, dy);
            contracted += fma(dx, dx, dy * dy) != distance2(dx, dy);
        }
    //<

    //> Look for distances that their roots confuse
    size_t equal = 0, confused = 0;
    qsort(distances, pairs, sizeof *distances, by_value);
    for (size_t k = 1; k < pairs; k++) {
        if (distances[k] == distances[k - 1])
            equal++;
        else if (sqrt(distances[k]) == sqrt(distances[k - 1]))
            confused++;
    }
    //<

    report_provenance(stdout);
    printf("name\tpairs\n"
           "all\t%zu\ncontracted\t%zu\nequal\t%zu\nconfused\t%zu\n",
           pairs, contracted, equal, confused);
    free(distances);
    points_free(&points);
    return 0;
}
//<
