//> Let the cells grow with the points, or not
// Distances computed for each point as the points grow in number, for
// cells that hold two points and for cells that hold sqrt(n).
//
//     crowding [MOST]
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/argument.h"
#include "common/count.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

//> Count one search
static void print_search(const struct question *question, double c,
                         struct answers *answers)
{
    const uint32_t n = question->points.n;
    struct sorted sorted = sorted_make(question, c, cells_sort_alone);
    counting_take();
    counting_search_sorted(question, &sorted, answers);
    printf("\t%.5g", (double)counting_take().distances / n);
    sorted_free(&sorted);
}
//<

int main(int argc, char **argv)
{
    fail_as("crowding");
    uint32_t most = argument(argc, argv, 1, "MOST", 25600, 100, MANY);
    report_provenance(stdout);
    puts("name\tn\ttwo\troot");
    for (uint64_t n = 100; n <= most; n *= 4) {
        struct question question = uniform_question(STANDARD, n, 1);
        struct answers answers = answers_allocate(n);
        printf("n_%u\t%u", (unsigned)n, (unsigned)n);
        print_search(&question, 2, &answers);
        print_search(&question, sqrt(n), &answers);
        puts("");
        fflush(stdout);
        answers_free(&answers);
        points_free(&question.points);
    }
    return 0;
}
//<
