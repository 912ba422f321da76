//> Draw points from every generator
// Prints the points of all generators, one after the other.
//
//     portraits [POINTS]
#include "common/argument.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/report.h"
#include <stdio.h>

int main(int argc, char **argv)
{
    fail_as("portraits");
    uint32_t n = argument(argc, argv, 1, "POINTS", 500, 1, MANY);

    report_provenance(stdout);
    puts("distribution\tx\ty");
    for (int d = 0; d < distribution_count; d++) {
        struct points points = generate(&distributions[d], n, 1);
        for (uint32_t i = 0; i < n; i++)
            printf("%s\t%.6g\t%.6g\n", distributions[d].name,
                   points.x[i], points.y[i]);
        points_free(&points);
    }
    return 0;
}
//<
