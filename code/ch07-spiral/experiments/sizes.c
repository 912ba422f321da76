// Distances a point for one and for two points to a cell, and the time
// of the table's search, with the queries as the points come and in the
// order of the cells: over several sets of points. And how many points
// fill the caches, at the bytes that a search reads of a point: two
// coordinates, an index, where a cell begins.
//     sizes [MOST [SETS]]
#include "ch06-pack-scan/experiments/caches.h"
#include "ch07-spiral/experiments/census.h"
#include "ch07-spiral/spiral.h"
#include "common/experiment.h"

enum { BYTES_READ = 24, LOTS = 1000000, MOST_SETS = 1000 };
enum {
    ONE,
    TWO,
    UNORDERED,
    ORDERED,
    COLUMNS
}; // the last two: ns a point

static void try_set(uint32_t n, int set,
                    double found[COLUMNS][MOST_SETS])
{
    struct question question = uniform_question(STANDARD, n, set + 1);
    struct answers *answers = new_answers(n, NEAREST);
    question.threads = omp_get_num_procs();
    found[ONE][set] = take_census(&question, 1).distances;
    found[TWO][set] = take_census(&question, 2).distances;
    question.threads = 1;
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    int64_t begin = clock_ns();
    search_spiral(&question, &grid, &cells, NULL, answers);
    int64_t middle = clock_ns();
    search_spiral(&question, &grid, &cells, cells.point, answers);
    found[UNORDERED][set] = (double)(middle - begin) / n;
    found[ORDERED][set] = (double)(clock_ns() - middle) / n;
    cells_free(&cells);
    grid_free(&grid);
    forget();
}

static void print_size(uint32_t n, int sets)
{
    static double found[COLUMNS][MOST_SETS];
    for (int set = 0; set < sets; set++)
        try_set(n, set, found);
    struct caches caches = caches_of_machine();
    row_begin("n%u\t%u\t%d", n, n, sets);
    for (int c = 0; c < COLUMNS; c++) {
        struct summary summary = summarize(found[c], sets);
        row_spread(&summary);
    }
    row_cells("\t%zu\t%zu", caches.l2 / BYTES_READ,
              caches.l3 / BYTES_READ);
    row_end();
}

// The largest sets are few: they take long, and differ little.
int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", LOTS, 1000, MANY);
    int sets = parameter(&e, "SETS", 3, 1, MOST_SETS);
    print_header(
        &e, "name n sets one:5 two:5 unordered:5 ordered:5 l2_points"
            " l3_points");
    for (uint32_t n = 1000; n <= most; n = next_size(n))
        print_size(n, n > LOTS && sets > 3 ? 3 : sets);
}
