// The spiral search beside chapter 4's, through indices like itself,
// and with the points of a cell together, as the table has them, on
// points of several kinds: the time, and the distances and cells a
// point.
//     compare [POINTS [TRIALS]]
#include "common/experiment.h"

static const struct {
    const char *algorithm, *name;
} searches[] = {{"cells-indices", "blocks"},
                {"cells", "together"},
                {"spiral", "spiral"}};
static const char *const kinds[] = {"uniform", "clustered", "circle",
                                    "kuzmin", "two-clusters"};

static void compare_on(const char *kind, uint32_t n, int trials)
{
    struct question question = kind_question(kind, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    const struct algorithm *algorithm[COUNT_OF(searches)];
    struct trial trial[COUNT_OF(searches)];
    for (int k = 0; k < COUNT_OF(searches); k++) {
        algorithm[k] = find_algorithm(searches[k].algorithm);
        trial[k] = search_trial(algorithm[k]->run, &question, answers);
    }
    time_in_turn(trials, trial, COUNT_OF(searches));
    question.threads = omp_get_num_procs();
    for (int k = 0; k < COUNT_OF(searches); k++) {
        struct counts counts =
            count_operations(algorithm[k], &question, answers);
        row_of_times(&trial[k], 1, n, "%s_%s\t%u\t%.6g\t%.6g",
                     searches[k].name, kind, n,
                     (double)counts.distances / n,
                     (double)counts.cells / n);
    }
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 5000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    print_header(&e, "name n distances cells ns:3");
    for (int k = 0; k < COUNT_OF(kinds); k++)
        compare_on(kinds[k], n, trials);
}
