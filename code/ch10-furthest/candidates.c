//> Count the candidates of the corner trick
// How many cells the corner trick looks at and how many points it
// meets, on average over uniform points, beside the prediction of four
// cells and a little; and the same for cells along the border.
//
//     candidates [MOST]
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/sorted.h"
#include "ch10-furthest/border.h"
#include "common/argument.h"
#include "common/count.h"
#include "common/fail.h"
#include "common/report.h"

//> Count both tricks
static void print_counts(const struct question *question, double c,
                         struct answers *answers)
{
    const uint32_t n = question->points.n;
    struct sorted sorted = sorted_make(question, c, cells_sort_alone);
    double side = sqrt(grid_cells(&sorted.grid));
    double mean = (double)n / grid_cells(&sorted.grid);
    counting_take();
    counting_search_edge_cells(question, &sorted, answers);
    struct counts edge = counting_take();
    counting_search_one_corner(question, &sorted, answers);
    struct counts corner = counting_take();
    printf("\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g", side,
           (double)edge.distances / n, 4 * (side - 1) * mean,
           (double)corner.cells / n, 4 + 15 / side,
           (double)corner.distances / n, (4 + 15 / side) * mean);
    sorted_free(&sorted);
}
//<

int main(int argc, char **argv)
{
    fail_as("candidates");
    uint32_t most = argument(argc, argv, 1, "MOST", 100000, 100, MANY);
    report_provenance(stdout);
    puts("name\tn"
         "\tside\tedge\tedge_expected\tcells\tcells_expected"
         "\tpoints\tpoints_expected"
         "\troot_side\troot_edge\troot_edge_expected\troot_cells"
         "\troot_cells_expected\troot_points\troot_points_expected");
    for (uint64_t n = 1000; n <= most; n *= 10) {
        struct question question = uniform_question(STANDARD, n, 1);
        struct answers answers = answers_allocate(n);
        printf("trick%u\t%u", (unsigned)n, (unsigned)n);
        print_counts(&question, 2, &answers);
        print_counts(&question, sqrt(n), &answers);
        puts("");
        fflush(stdout);
        answers_free(&answers);
        points_free(&question.points);
    }
    return 0;
}
//<
