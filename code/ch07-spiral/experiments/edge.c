// What the edge of the square saves: distances a point with one point
// in a cell, over many sets of points, in both geometries. With
// wraparound there is no edge.
//     edge [POINTS [SETS]]
#include "ch07-spiral/experiments/census.h"
#include "ch07-spiral/experiments/expected.h"
#include "common/experiment.h"

// The mean over all sets, of which the first has seed 1.
static struct census mean_census(enum geometry geometry, uint32_t n,
                                 int sets)
{
    struct census mean = {0};
    for (int set = 1; set <= sets; set++) {
        struct question question = uniform_question(geometry, n, set);
        struct census census = take_census(&question, 1);
        mean.per_cell += census.per_cell / sets;
        mean.distances += census.distances / sets;
        forget();
    }
    return mean;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000, 2, MANY);
    int sets = parameter(&e, "SETS", 100, 1, MANY);
    print_header(&e, "name n sets c standard wraparound expected");
    double standard = mean_census(STANDARD, n, sets).distances;
    struct census around = mean_census(WRAPAROUND, n, sets);
    row("edge\t%u\t%d\t%.6g\t%.6g\t%.6g\t%.6g", n, sets,
        around.per_cell, standard, around.distances,
        expected_spiral(around.per_cell).distances);
}
