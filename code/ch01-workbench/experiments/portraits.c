// Prints the points of all generators, one after the other.
//     portraits [POINTS]
#include "common/experiment.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 500, 1, MANY);
    print_header(&e, "distribution x y");
    for (int d = 0; d < distribution_count; d++) {
        struct points points = generate(&distributions[d], n, 1);
        for (uint32_t i = 0; i < n; i++)
            printf("%s\t%.6g\t%.6g\n", distributions[d].name,
                   points.x[i], points.y[i]);
        points_free(&points);
    }
}
