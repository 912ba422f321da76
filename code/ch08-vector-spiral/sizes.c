//> Vary the number of points, one by one and in step
// Distances a point, and the time with the sort: of the spiral search,
// with the points asking as they come and in the order of the cells,
// and of the vectorized one; over several sets of points, uniform and
// clustered.
//
//     sizes [MOST [SETS]]
#include "ch02-all-pairs/timing.h"
#include "ch07-spiral/census.h"
#include "ch07-spiral/spiral.h"
#include "ch08-vector-spiral/fused.h"
#include "ch08-vector-spiral/march.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include "ch08-vector-spiral/versions.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

enum { LEAST = 1000, LOTS = 1000000, FEW_SETS = 3 };
enum { SEQUENTIAL, VECTOR, COMING, ORDERED, MARCHING, COLUMNS };

static const char *const columns[COLUMNS] = {
    "sequential", "vector", "coming", "ordered", "marching"};
static const char *const kinds[] = {"uniform", "clustered"};

//> Count and time a set of points
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
    question.threads = omp_get_num_procs();
    struct answers answers = answers_allocate(n);
    struct loops loops = loops_fused(isa_chosen());
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    struct tally tally;
    march(&question, &grid, &cells, &loops, STRIP, &answers, &tally,
          NULL);
    cells_free(&cells);
    grid_free(&grid);
    double found[COLUMNS];
    found[SEQUENTIAL] = take_census(&question, 1).distances;
    found[VECTOR] = (double)tally.points / n;
    question.threads = 1;
    found[COMING] = time_search(spiral, &question, &answers);
    found[ORDERED] = time_search(spiral_in_order, &question, &answers);
    found[MARCHING] = time_search(vector_spiral, &question, &answers);
    for (int c = 0; c < COLUMNS; c++)
        values[c * sets + set] = found[c];
    answers_free(&answers);
    points_free(&question.points);
}
//<

static void print_size(const char *kind, uint32_t n, int sets,
                       double *values)
{
    for (int set = 0; set < sets; set++)
        try_set(kind, n, set, values, sets);
    printf("%s_n%u\t%s\t%u\t%d", kind, n, kind, n, sets);
    for (int c = 0; c < COLUMNS; c++) {
        struct summary s = summarize(values + c * sets, sets);
        printf("\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g", s.median, s.q1, s.q3,
               s.min, s.max);
    }
    puts("");
}

// The largest sets are few: they take long, and differ little.
int main(int argc, char **argv)
{
    fail_as("sizes");
    uint32_t most =
        argument(argc, argv, 1, "MOST", 100000, LEAST, MANY);
    int sets = argument(argc, argv, 2, "SETS", 3, 1, 1000);
    double *values = allocate((size_t)COLUMNS * sets, sizeof *values);
    report_provenance(stdout);
    printf("name\tkind\tn\tsets");
    for (int c = 0; c < COLUMNS; c++)
        printf("\t%s\t%s_q1\t%s_q3\t%s_min\t%s_max", columns[c],
               columns[c], columns[c], columns[c], columns[c]);
    puts("");
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
//<
