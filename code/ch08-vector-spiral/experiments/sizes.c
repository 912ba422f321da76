// Distances a point, and the time with the sort: of the spiral search,
// with the queries as they come and in the order of the cells,
// and of the vectorized one; over several sets of points, uniform and
// clustered.
//     sizes [MOST [SETS]]
#include "ch07-spiral/experiments/census.h"
#include "ch07-spiral/spiral.h"
#include "ch08-vector-spiral/experiments/versions.h"
#include "ch08-vector-spiral/lockstep.h"
#include "ch08-vector-spiral/spiral_kernels.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include "common/experiment.h"

enum { LOTS = 1000000, FEW_SETS = 3, MOST_SETS = 1000 };
enum { SEQUENTIAL, VECTOR, UNORDERED, ORDERED, IN_STEP, COLUMNS };

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

static double compared_in_step(const struct question *question,
                               struct answers *answers)
{
    struct grid grid = grid_fit(question, 1);
    struct cells cells = cells_sort(&grid, question->points);
    struct tally tally;
    struct strip_plan plan = {spiral_kernels(isa_chosen()), STRIP,
                              &tally};
    search_in_lockstep(question, &grid, &cells, &plan, answers);
    cells_free(&cells);
    grid_free(&grid);
    return (double)tally.compared / question->points.n;
}

static void try_set(const char *kind, uint32_t n, int set,
                    double found[COLUMNS][MOST_SETS])
{
    struct question question = kind_question(kind, n, set + 1);
    struct answers *answers = new_answers(n, BOTH);
    question.threads = omp_get_num_procs();
    found[SEQUENTIAL][set] = take_census(&question, 1).distances;
    found[VECTOR][set] = compared_in_step(&question, answers);
    question.threads = 1;
    found[UNORDERED][set] = time_search(spiral, &question, answers);
    found[ORDERED][set] =
        time_search(spiral_in_order, &question, answers);
    found[IN_STEP][set] =
        time_search(vector_spiral, &question, answers);
    forget();
}

// The largest sets are few: they take long, and differ little.
static void print_sizes(const char *kind, uint32_t most, int all_sets)
{
    static double found[COLUMNS][MOST_SETS];
    for (uint32_t n = 1000; n <= most; n = next_size(n)) {
        bool few = n >= LOTS && all_sets > FEW_SETS;
        const int sets = few ? FEW_SETS : all_sets;
        for (int set = 0; set < sets; set++)
            try_set(kind, n, set, found);
        row_begin("%s_n%u\t%s\t%u\t%d", kind, n, kind, n, sets);
        for (int c = 0; c < COLUMNS; c++) {
            struct summary summary = summarize(found[c], sets);
            row_spread(&summary);
        }
        row_end();
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 100000, 1000, MANY);
    int sets = parameter(&e, "SETS", 3, 1, MOST_SETS);
    print_header(&e,
                 "name kind n sets sequential:5 vector:5 unordered:5"
                 " ordered:5 in_step:5");
    print_sizes("uniform", most, sets);
    print_sizes("clustered", most, sets);
}
