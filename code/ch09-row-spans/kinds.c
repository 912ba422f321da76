//> Try points of every kind
// Row spans on points that are spread unevenly: the time with one
// thread and with all processors, the distances, and how many ask
// alone; beside chapter 4's best and the spiral.
//
//     kinds [POINTS [MORE [TRIALS]]]
// MORE are the points of those kinds that do not crowd. What allocates
// much runs once before it is timed.
#include "algorithms.h"
#include "ch02-all-pairs/timing.h"
#include "ch09-row-spans/keep.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
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
    print_word(stdout, kind);
    printf("\t%u\t%d\t%.5g\t%.4g", n, omp_get_num_procs(),
           (double)counts.distances / n, (double)counts.tasks / n);
    for (int k = 0; k < WAYS; k++)
        print_summary(&trial[k].summary, n);
    puts("");
    answers_free(&answers);
    points_free(&question.points);
}

int main(int argc, char **argv)
{
    fail_as("kinds");
    memory_keep();
    uint32_t n = argument(argc, argv, 1, "POINTS", 5000, 2, MANY);
    uint32_t more = argument(argc, argv, 2, "MORE", 100000, 2, MANY);
    int count = argument(argc, argv, 3, "TRIALS", 3, 1, MANY);
    report_provenance(stdout);
    puts("name\tn\tthreads\tdistances\talone"
         "\tspiral\tspiral_q1\tspiral_q3\tcells\tcells_q1\tcells_q3"
         "\tspans\tspans_q1\tspans_q3\tall\tall_q1\tall_q3");
    print_kind("uniform", more, count);
    print_kind("clustered", more, count);
    print_kind("lattice", more, count);
    print_kind("circle", n, count);
    print_kind("kuzmin", n, count);
    print_kind("two-clusters", n, count);
    print_kind("equal", n, count);
    return 0;
}
//<
