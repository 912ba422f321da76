// How many cells the corner trick looks at and how many points it
// meets, on average over uniform points, beside the prediction of four
// cells and a little; and the same for cells along the border.
//     candidates [MOST]
#include "ch04-cell-sort/sorted.h"
#include "ch10-furthest/coursework_furthest.h"
#include "common/experiment.h"

static void print_counts(struct question question, double c)
{
    const uint32_t n = question.points.n;
    struct sorted sorted = sorted_make(&question, c);
    struct answers *answers = new_answers(n, FURTHEST);
    double side = sqrt(grid_cells(&sorted.grid));
    double mean = (double)n / grid_cells(&sorted.grid);
    struct counts edge = {0}, corner = {0};
    question.counts = &edge;
    search_edge_cells(&question, &sorted, answers);
    question.counts = &corner;
    search_one_corner(&question, &sorted, answers);
    row_cells("\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g\t%.5g", side,
              (double)edge.distances / n, 4 * (side - 1) * mean,
              (double)corner.cells / n, 4 + 15 / side,
              (double)corner.distances / n, (4 + 15 / side) * mean);
    sorted_free(&sorted);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 100000, 100, MANY / 10);
    print_header(&e,
                 "name n side edge edge_expected cells cells_expected "
                 "points points_expected root_side root_edge "
                 "root_edge_expected root_cells root_cells_expected "
                 "root_points root_points_expected");
    for (uint32_t n = 1000; n <= most; n *= 10) {
        struct question question = uniform_question(STANDARD, n, 1);
        row_begin("trick%u\t%u", n, n);
        print_counts(question, 2);
        print_counts(question, sqrt(n));
        row_end();
        forget();
    }
}
