// Distances computed for each point as the points grow in number, for
// cells that hold two points and for cells that hold sqrt(n).
//
//     crowding [MOST]
#include "ch04-cell-sort/point_by_point.h"
#include "common/experiment.h"

static void print_search(const struct question *question, double c,
                         struct answers *answers)
{
    const uint32_t n = question->points.n;
    struct sorted sorted = sorted_make(question, c, cells_sort_alone);
    struct counts counts = {0};
    struct question counted = *question;
    counted.counts = &counts;
    search_sorted(&counted, &sorted, answers);
    row_cells("\t%.5g", (double)counts.distances / n);
    sorted_free(&sorted);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 25600, 100, MANY);
    columns(&e, "name n two root");
    for (uint64_t n = 100; n <= most; n *= 4) {
        struct question question = uniform_question(STANDARD, n, 1);
        struct answers answers = answers_allocate(n);
        row_begin("n_%u\t%u", (unsigned)n, (unsigned)n);
        print_search(&question, 2, &answers);
        print_search(&question, sqrt(n), &answers);
        row_end();
        answers_free(&answers);
        points_free(&question.points);
    }
    return 0;
}
