//> Expect and count what the search from outside looks at
// Cells with points and distances for a point, in both geometries, of
// uniform points: expected where only one corner matters, or with
// wraparound far from any seam, and counted.
//
//     visits [MOST [SETS]]
#include "algorithms.h"
#include "ch02-all-pairs/timing.h"
#include "ch10-furthest/expected_far.h"
#include "ch10-furthest/furthest_cells.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"

//> Print what was expected and counted
// A cell without points is not looked at. With wraparound home is never
// empty, and a point there meets itself.
static void print_visits(enum geometry geometry, uint32_t n, int sets)
{
    const double c = POINTS_PER_FAR_CELL, all = (double)n * sets;
    const double home = geometry == WRAPAROUND ? 1 : 0;
    const double cells = expected_outside(geometry, c);
    struct counts sum = {0};
    struct answers answers = answers_for(n, FURTHEST);
    for (int set = 0; set < sets; set++) {
        struct question question =
            uniform_question(geometry, n, set + 1);
        struct counts counts = count_operations(
            find_algorithm("furthest-cells"), &question, &answers);
        sum.cells += counts.cells;
        sum.distances += counts.distances;
        points_free(&question.points);
    }
    printf("%s_visits_%u\t%u\t%d\t%.4g\t%.4g\t%.4g\t%.4g\t%.4g\n",
           home > 0 ? "wraparound" : "standard", n, n, sets, c,
           home + (cells - home) * (1 - exp(-c)), sum.cells / all,
           home + cells * c, sum.distances / all);
    fflush(stdout);
    answers_free(&answers);
}
//<

int main(int argc, char **argv)
{
    fail_as("visits", NULL);
    uint32_t most = argument(argc, argv, 1, "MOST", 10000, 1000, MANY);
    int sets = argument(argc, argv, 2, "SETS", 10, 1, MANY);
    report_provenance(stdout);
    puts("name\tn\tsets\tc\tcells_expected\tcells\tdistances_expected"
         "\tdistances");
    for (uint64_t n = 1000; n <= most; n *= 10)
        print_visits(STANDARD, n, sets);
    for (uint64_t n = 1000; n <= most; n *= 10)
        print_visits(WRAPAROUND, n, sets);
    return 0;
}
//<
