// Distances a point for one and for two points to a cell, and the time
// of the search that the table has, with the queries as the points come
// and in the order of the cells: over several sets of points. And how
// many points fill the caches, if each query goes at random for what
// the search reads of a point: two coordinates, an index, where a cell
// begins.
//
//     sizes [MOST [SETS]]
#include "ch06-pack-scan/experiments/caches.h"
#include "ch07-spiral/experiments/census.h"
#include "ch07-spiral/spiral.h"
#include "common/allocate.h"
#include "common/experiment.h"
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

enum { BYTES_READ = 24, LOTS = 1000000 };

struct samples {
    double *one, *two;        // distances a point
    double *coming, *ordered; // ns a point, without the sort
};

static double time_search(const struct question *question,
                          const struct grid *grid,
                          const struct cells *cells,
                          const uint32_t *order,
                          struct answers *answers)
{
    int64_t begin = clock_ns();
    search_spiral(question, grid, cells, order, answers);
    return (double)(clock_ns() - begin) / question->points.n;
}

static void try_set(uint32_t n, int set, struct samples *samples)
{
    struct question question = uniform_question(STANDARD, n, set + 1);
    struct answers answers = answers_allocate(n);
    question.threads = omp_get_num_procs();
    samples->one[set] = take_census(&question, 1).distances;
    samples->two[set] = take_census(&question, 2).distances;
    question.threads = 1;
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    samples->coming[set] =
        time_search(&question, &grid, &cells, NULL, &answers);
    samples->ordered[set] =
        time_search(&question, &grid, &cells, cells.point, &answers);
    cells_free(&cells);
    grid_free(&grid);
    answers_free(&answers);
    points_free(&question.points);
}

static void print_five(double *values, int sets)
{
    struct summary s = summarize(values, sets);
    row_spread(&s);
}

static void print_size(uint32_t n, int sets, struct samples *samples)
{
    for (int set = 0; set < sets; set++)
        try_set(n, set, samples);
    struct caches caches = caches_of_machine();
    row_begin("n%u\t%u\t%d", n, n, sets);
    print_five(samples->one, sets);
    print_five(samples->two, sets);
    print_five(samples->coming, sets);
    print_five(samples->ordered, sets);
    row_cells("\t%zu\t%zu", caches.l2 / BYTES_READ,
              caches.l3 / BYTES_READ);
    row_end();
}

// The largest sets are few: they take long, and differ little.
int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", LOTS, 1000, MANY);
    int sets = parameter(&e, "SETS", 3, 1, 1000);
    double *room = allocate(4 * (size_t)sets, sizeof *room);
    struct samples samples = {room, room + sets, room + 2 * sets,
                              room + 3 * sets};
    columns(&e, "name n sets one:5 two:5 coming:5 ordered:5 l2_points"
                " l3_points");
    for (uint64_t n = 1000; n <= most; n *= 10)
        for (int times = 1; times <= 3; times += 2) {
            uint64_t points = times * n;
            if (points <= most)
                print_size(points, points > LOTS && sets > 3 ? 3 : sets,
                           &samples);
        }
    free(room);
    return 0;
}
