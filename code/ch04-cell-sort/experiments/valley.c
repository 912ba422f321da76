// Build and search, nanoseconds a point, on one thread, for
// several numbers of points in a cell and three searches.
//     valley [POINTS [TRIALS]]
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/experiment.h"

static const double per_cell[] = {0.5, 0.75, 1, 1.5, 2,
                                  3,   4,    6, 10,  16};
enum { SIZES = COUNT_OF(per_cell), SEARCHES = 3 };

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

static void point_by_point(void *context)
{
    struct attempt *a = context;
    struct sorted sorted = sorted_make(a->question, a->c);
    search_sorted(a->question, &sorted, a->answers);
    sorted_free(&sorted);
}

static void in_batches(void *context)
{
    struct attempt *a = context;
    struct sorted sorted = sorted_make(a->question, a->c);
    search_batches(a->question, &sorted, a->answers);
    sorted_free(&sorted);
}

static void (*const searches[SEARCHES])(void *) = {
    by_lists, point_by_point, in_batches};

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    struct attempt attempts[SIZES];
    struct trial versions[SIZES * SEARCHES];
    for (int s = 0; s < SIZES; s++)
        attempts[s] = (struct attempt){&question, answers, per_cell[s]};
    for (int v = 0; v < SIZES * SEARCHES; v++)
        versions[v] = (struct trial){searches[v % SEARCHES],
                                     &attempts[v / SEARCHES]};
    time_in_turn(trials, versions, SIZES * SEARCHES);
    print_header(&e, "name c lists:3 sorted:3 batches:3");
    for (int s = 0; s < SIZES; s++)
        row_of_times(&versions[s * SEARCHES], SEARCHES, n,
                     "size_%d\t%g", s, per_cell[s]);
}
