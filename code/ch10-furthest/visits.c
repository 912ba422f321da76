//> Expect and count what the search from outside looks at
// Cells with points and distances for a point, in both geometries, of
// uniform points: expected where only one corner matters, or with
// wraparound far from any seam, and counted.
//
//     visits [MOST [SETS]]
#include "algorithms.h"
#include "ch02-all-pairs/timing.h"
#include "ch09-row-spans/carry.h"
#include "ch10-furthest/expected_far.h"
#include "ch10-furthest/furthest_cells.h"
#include "common/argument.h"
#include "common/count.h"
#include "common/fail.h"
#include "common/report.h"

//> Count visits
// Of so many sets of points, added up.
static struct counts count_visits(enum geometry geometry,
                                  enum manner manner, uint32_t n,
                                  int sets)
{
    struct counts sum = {0};
    struct answers answers = answers_for(n, FURTHEST);
    for (int set = 0; set < sets; set++) {
        struct question question =
            uniform_question(geometry, n, set + 1);
        struct carried carried =
            carry_points(&question, POINTS_PER_FAR_CELL);
        counting_take();
        counting_search_furthest_cells(&question, &carried, manner,
                                       &answers);
        struct counts counts = counting_take();
        sum.cells += counts.cells;
        sum.distances += counts.distances;
        carried_free(&carried);
        points_free(&question.points);
    }
    answers_free(&answers);
    return sum;
}
//<

//> Print what was expected and counted
// A cell without points is not looked at. With wraparound home is never
// empty, and a point there meets itself.
static void print_visits(enum geometry geometry, uint32_t n, int sets)
{
    const double c = POINTS_PER_FAR_CELL, all = (double)n * sets;
    const double home = geometry == WRAPAROUND ? 1 : 0;
    const double cells = expected_outside(geometry, c);
    struct counts alone = count_visits(geometry, ALONE, n, sets);
    struct counts together = count_visits(geometry, TOGETHER, n, sets);
    printf("%s_visits_%u\t%u\t%d\t%.4g\t%.4g\t%.4g\t%.4g\t%.4g\t%.4g"
           "\t%.4g\n",
           home > 0 ? "wraparound" : "standard", n, n, sets, c,
           home + (cells - home) * (1 - exp(-c)), alone.cells / all,
           home + cells * c, alone.distances / all,
           together.cells / all, together.distances / all);
    fflush(stdout);
}
//<

int main(int argc, char **argv)
{
    fail_as("visits");
    uint32_t most = argument(argc, argv, 1, "MOST", 10000, 1000, MANY);
    int sets = argument(argc, argv, 2, "SETS", 10, 1, MANY);
    report_provenance(stdout);
    puts("name\tn\tsets\tc\tcells_expected\tcells\tdistances_expected"
         "\tdistances\tcells_together\tdistances_together");
    for (uint64_t n = 1000; n <= most; n *= 10)
        print_visits(STANDARD, n, sets);
    for (uint64_t n = 1000; n <= most; n *= 10)
        print_visits(WRAPAROUND, n, sets);
    return 0;
}
//<
