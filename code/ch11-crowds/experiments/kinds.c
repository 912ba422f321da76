// Nanoseconds a point of the searches by pieces, on points of every
// kind, beside row spans on uniform points, in the same run. What is
// fast on even points is timed there only.
//
//     kinds [POINTS [TRIALS]]
#include "algorithms.h"
#include "common/experiment.h"
#include "common/generate.h"
#include "common/workspace.h"

static void print_kind(const char *kind, uint32_t n, int trials)
{
    const struct {
        const char *algorithm, *kind;
        unsigned answers;
    } ways[] = {{"row-spans", "uniform", NEAREST},
                {"near-and-far", "uniform", BOTH},
                {"by-sample", kind, NEAREST},
                {"by-sample", kind, BOTH},
                {"adaptive", kind, NEAREST}};
    enum { WAYS = COUNT_OF(ways) };
    struct workspace workspace[WAYS] = {0};
    struct trial trial[WAYS];
    for (int k = 0; k < WAYS; k++) {
        struct question question = kind_question(ways[k].kind, n, 1);
        question.workspace = &workspace[k];
        trial[k] =
            search_trial(find_algorithm(ways[k].algorithm)->run,
                         &question, new_answers(n, ways[k].answers));
    }
    time_in_turn(trials, trial, WAYS);
    row_of_times(trial, WAYS, n, "%s\t%u", kind, n);
    for (int k = 0; k < WAYS; k++)
        workspace_free(&workspace[k]);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    print_header(&e, "name n spans:3 even:3 near:3 both:3 adaptive:3");
    for (int d = 0; d < distribution_count; d++)
        print_kind(distributions[d].name, n, trials);
}
