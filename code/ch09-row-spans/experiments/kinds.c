// Row spans on points that are spread unevenly: the time with one
// thread and with all processors, the distances, and how many ask
// alone; beside chapter 4's best and the spiral.
//
//     kinds [POINTS [MORE [TRIALS]]]
// MORE are the points of those kinds that do not crowd. What allocates
// much runs once before it is timed.
#include "algorithms.h"
#include "common/experiment.h"
#include "common/workspace.h"
#include <omp.h>

static const struct {
    const char *algorithm;
    int all; // processors
} ways[] = {
    {"spiral", 0}, {"cells", 0}, {"row-spans", 0}, {"row-spans", 1}};
enum { WAYS = sizeof ways / sizeof *ways };

static void print_kind(const char *kind, uint32_t n, int count)
{
    struct question question = kind_question(kind, n, 1);
    struct workspace workspace = {0};
    question.workspace = &workspace;
    struct answers answers = answers_for(n, NEAREST);
    struct search search[WAYS];
    struct trial trial[WAYS];
    for (int k = 0; k < WAYS; k++) {
        question.threads = ways[k].all ? omp_get_num_procs() : 1;
        search[k] = (struct search){
            find_algorithm(ways[k].algorithm)->run, question, &answers};
        trial[k] = (struct trial){.work = run_search,
                                  .prepare = k ? run_search : NULL,
                                  .context = &search[k]};
    }
    time_in_turn(count, trial, WAYS);
    struct counts counts = count_operations(find_algorithm("row-spans"),
                                            &question, &answers);
    row_of_times(trial, WAYS, n, "%s\t%u\t%d\t%.5g\t%.4g", kind, n,
                 omp_get_num_procs(), (double)counts.distances / n,
                 (double)counts.tasks / n);
    workspace_free(&workspace);
    answers_free(&answers);
    points_free(&question.points);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 5000, 2, MANY);
    uint32_t more = parameter(&e, "MORE", 100000, 2, MANY);
    int count = parameter(&e, "TRIALS", 3, 1, MANY);
    columns(&e, "name n threads distances alone spiral:3 cells:3 "
                "spans:3 all:3");
    print_kind("uniform", more, count);
    print_kind("clustered", more, count);
    print_kind("lattice", more, count);
    print_kind("circle", n, count);
    print_kind("kuzmin", n, count);
    print_kind("two-clusters", n, count);
    print_kind("equal", n, count);
    return 0;
}
