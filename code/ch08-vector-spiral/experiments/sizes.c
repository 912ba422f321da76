// Distances a point, and the time with the sort: of the spiral search,
// with the queries as they come and in the order of the cells,
// and of the vectorized one; over several sets of points, uniform and
// clustered.
//
//     sizes [MOST [SETS]]
#include "ch07-spiral/experiments/census.h"
#include "ch07-spiral/spiral.h"
#include "ch08-vector-spiral/advance.h"
#include "ch08-vector-spiral/experiments/versions.h"
#include "ch08-vector-spiral/spiral_kernels.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include "common/allocate.h"
#include "common/experiment.h"
#include <omp.h>
#include <stdlib.h>

enum { LEAST = 1000, LOTS = 1000000, FEW_SETS = 3 };
enum { SEQUENTIAL, VECTOR, COMING, ORDERED, MARCHING, COLUMNS };

static const char *const kinds[] = {"uniform", "clustered"};

// In memory that was just given back; small sets run once before, to
// warm the caches.
static double time_search(search_function *search,
                          const struct question *question,
                          struct answers *answers)
{
    if (question->points.n < LOTS)
        search(question, answers);
    int64_t begin = clock_ns();
    search(question, answers);
    return (double)(clock_ns() - begin) / question->points.n;
}

static void try_set(const char *kind, uint32_t n, int set,
                    double *values, int sets)
{
    struct question question = kind_question(kind, n, set + 1);
    struct answers answers = answers_allocate(n);
    question.threads = omp_get_num_procs();
    const struct spiral_kernels *kernels = spiral_kernels(isa_chosen());
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    struct tally tally;
    struct strip_plan plan = {kernels, STRIP, &tally, NULL};
    advance_tasks(&question, &grid, &cells, &plan, &answers);
    cells_free(&cells);
    grid_free(&grid);
    double found[COLUMNS];
    found[SEQUENTIAL] = take_census(&question, 1).distances;
    found[VECTOR] = (double)tally.compared / n;
    question.threads = 1;
    found[COMING] = time_search(spiral, &question, &answers);
    found[ORDERED] = time_search(spiral_in_order, &question, &answers);
    found[MARCHING] = time_search(vector_spiral, &question, &answers);
    for (int c = 0; c < COLUMNS; c++)
        values[c * sets + set] = found[c];
    answers_free(&answers);
    points_free(&question.points);
}

static void print_size(const char *kind, uint32_t n, int sets,
                       double *values)
{
    for (int set = 0; set < sets; set++)
        try_set(kind, n, set, values, sets);
    row_begin("%s_n%u\t%s\t%u\t%d", kind, n, kind, n, sets);
    for (int c = 0; c < COLUMNS; c++) {
        struct summary s = summarize(values + c * sets, sets);
        row_spread(&s);
    }
    row_end();
}

// The largest sets are few: they take long, and differ little.
int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 100000, LEAST, MANY);
    int sets = parameter(&e, "SETS", 3, 1, 1000);
    double *values = allocate((size_t)COLUMNS * sets, sizeof *values);
    columns(&e, "name kind n sets sequential:5 vector:5 coming:5"
                " ordered:5 marching:5");
    for (int kind = 0; kind < 2; kind++)
        for (uint64_t n = LEAST; n <= most; n *= 10)
            for (int third = 0; third < 2; third++) {
                uint64_t points = third ? 3 * n : n;
                bool few = points >= LOTS && sets > FEW_SETS;
                if (points <= most)
                    print_size(kinds[kind], points,
                               few ? FEW_SETS : sets, values);
            }
    free(values);
    return 0;
}
