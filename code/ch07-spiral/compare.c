//> Compare spirals with blocks
// The spiral search beside chapter 4's, through indices like itself,
// and with the points of a cell together, as the table has them, on
// points of several kinds: the time, and the distances and cells a
// point.
//
//     compare [POINTS [TRIALS]]
#include "algorithms.h"
#include "ch02-all-pairs/timing.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>
#include <stdio.h>

static const struct {
    const char *algorithm, *name;
} searches[] = {{"cells-indices", "blocks"},
                {"cells", "together"},
                {"spiral", "spiral"}};
static const char *const kinds[] = {"uniform", "clustered", "circle",
                                    "kuzmin", "two-clusters"};
enum { SEARCHES = 3, KINDS = sizeof kinds / sizeof *kinds };

static void compare_on(const char *kind, uint32_t n, int trials)
{
    struct question question = kind_question(kind, n, 1);
    struct answers answers = answers_allocate(n);
    struct search search[SEARCHES];
    struct trial trial[SEARCHES];
    for (int k = 0; k < SEARCHES; k++) {
        search[k] =
            (struct search){find_algorithm(searches[k].algorithm)->run,
                            question, &answers};
        trial[k] =
            (struct trial){.work = run_search, .context = &search[k]};
    }
    time_in_turn(trials, trial, SEARCHES);
    question.threads = omp_get_num_procs();
    for (int k = 0; k < SEARCHES; k++) {
        struct counts counts = count_operations(
            find_algorithm(searches[k].algorithm), &question, &answers);
        printf("%s_", searches[k].name);
        print_word(stdout, kind);
        printf("\t%u\t%.6g\t%.6g", n, (double)counts.distances / n,
               (double)counts.cells / n);
        print_summary(&trial[k].summary, n);
        puts("");
    }
    answers_free(&answers);
    points_free(&question.points);
}

int main(int argc, char **argv)
{
    fail_as("compare");
    uint32_t n = argument(argc, argv, 1, "POINTS", 5000, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    report_provenance(stdout);
    puts("name\tn\tdistances\tcells\tns\tns_q1\tns_q3");
    for (int k = 0; k < KINDS; k++)
        compare_on(kinds[k], n, trials);
    return 0;
}
//<
