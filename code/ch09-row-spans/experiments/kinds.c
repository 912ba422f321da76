// Row spans on points that are spread unevenly: the time with one
// thread and with all processors, the distances, and how many points
// are queried alone; beside chapter 4's best and the spiral.
//     kinds [POINTS [MORE [TRIALS]]]
// MORE are the points of those kinds that do not crowd. What allocates
// much runs once before it is timed.
#include "common/experiment.h"

static const struct {
    const char *algorithm;
    bool all; // processors
} ways[] = {{"spiral", false},
            {"cells", false},
            {"row-spans", false},
            {"row-spans", true}};
enum { WAYS = COUNT_OF(ways) };

static void print_kind(const char *kind, uint32_t n, int count)
{
    struct question question = kind_question(kind, n, 1);
    struct workspace workspace = {0};
    question.workspace = &workspace;
    struct answers *answers = new_answers(n, NEAREST);
    const struct algorithm *algorithm = NULL;
    struct trial trial[WAYS];
    for (int k = 0; k < WAYS; k++) {
        question.threads = ways[k].all ? omp_get_num_procs() : 1;
        algorithm = find_algorithm(ways[k].algorithm);
        trial[k] = search_trial(algorithm->run, &question, answers);
        trial[k].prepare = k ? trial[k].work : NULL;
    }
    time_in_turn(count, trial, WAYS);
    struct counts counts = // of the last way
        count_operations(algorithm, &question, answers);
    row_of_times(trial, WAYS, n, "%s\t%u\t%d\t%.5g\t%.4g", kind, n,
                 question.threads, (double)counts.distances / n,
                 (double)counts.exact / n);
    workspace_free(&workspace);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 5000, 2, MANY);
    uint32_t more = parameter(&e, "MORE", 100000, 2, MANY);
    int count = parameter(&e, "TRIALS", 3, 1, MANY);
    print_header(&e, "name n threads distances exact spiral:3 cells:3 "
                     "spans:3 all:3");
    print_kind("uniform", more, count);
    print_kind("clustered", more, count);
    print_kind("lattice", more, count);
    print_kind("circle", n, count);
    print_kind("kuzmin", n, count);
    print_kind("two-clusters", n, count);
    print_kind("equal", n, count);
}
