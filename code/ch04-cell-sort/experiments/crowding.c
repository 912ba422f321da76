// Distances computed for each point as the points grow in number, for
// cells that hold two points and for cells that hold sqrt(n).
//     crowding [MOST]
#include "ch04-cell-sort/point_by_point.h"
#include "common/experiment.h"

static double distances(uint32_t n, double c)
{
    struct question question = uniform_question(STANDARD, n, 1);
    struct sorted sorted = sorted_make(&question, c);
    struct counts counts = {0};
    question.counts = &counts;
    search_sorted(&question, &sorted, new_answers(n, NEAREST));
    sorted_free(&sorted);
    forget();
    return (double)counts.distances / n;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 25600, 100, MANY);
    print_header(&e, "name n two root");
    for (uint32_t n = 100; n <= most; n *= 4)
        row("n_%u\t%u\t%.5g\t%.5g", n, n, distances(n, 2),
            distances(n, sqrt(n)));
}
