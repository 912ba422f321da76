//> Try cells of all sizes
// Build and search together, nanoseconds a point, on one thread, for
// several numbers of points in a cell and three searches.
//
//     valley [POINTS [TRIALS]]
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/point_by_point.h"
#include "ch04-cell-sort/together.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

enum { SIZES = 10, SEARCHES = 3 };

static const double per_cell[SIZES] = {0.5, 0.75, 1, 1.5, 2,
                                       3,   4,    6, 10,  16};

struct attempt {
    const struct question *question;
    struct answers *answers;
    double c;
};

static void by_lists(void *context)
{
    struct attempt *a = context;
    struct grid grid = grid_fit(a->question, a->c);
    struct lists lists = lists_make(&grid, a->question->points);
    search_lists(a->question, &grid, &lists, NULL, a->answers);
    lists_free(&lists);
    grid_free(&grid);
}

//> Sort and search with so many points in a cell
static void by_sorting(const struct attempt *a,
                       void (*search)(const struct question *,
                                      const struct sorted *,
                                      struct answers *))
{
    struct sorted sorted =
        sorted_make(a->question, a->c, cells_sort_alone);
    search(a->question, &sorted, a->answers);
    sorted_free(&sorted);
}
//<

static void one_by_one(void *context)
{
    by_sorting(context, search_sorted);
}

static void all_together(void *context)
{
    by_sorting(context, search_together);
}

int main(int argc, char **argv)
{
    fail_as("valley");
    uint32_t n = argument(argc, argv, 1, "POINTS", 20000, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers answers = answers_allocate(n);
    struct attempt attempts[SIZES];
    void (*const searches[SEARCHES])(void *) = {by_lists, one_by_one,
                                                all_together};
    struct trial versions[SIZES][SEARCHES];
    for (int s = 0; s < SIZES; s++) {
        attempts[s] =
            (struct attempt){&question, &answers, per_cell[s]};
        for (int k = 0; k < SEARCHES; k++)
            versions[s][k] = (struct trial){.work = searches[k],
                                            .context = &attempts[s]};
    }
    time_in_turn(trials, versions[0], SIZES * SEARCHES);
    report_provenance(stdout);
    puts("name\tc\tlists\tlists_q1\tlists_q3"
         "\tsorted\tsorted_q1\tsorted_q3"
         "\ttogether\ttogether_q1\ttogether_q3");
    for (int s = 0; s < SIZES; s++) {
        printf("size_%d\t%g", s, per_cell[s]);
        for (int k = 0; k < SEARCHES; k++)
            print_summary(&versions[s][k].summary, n);
        puts("");
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
//<
