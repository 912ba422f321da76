// Nanoseconds a point of the searches by pieces, on points of every
// kind, beside row spans on uniform points, in the same run. What is
// fast on even points is timed there only.
//
//     kinds [POINTS [TRIALS]]
#include "algorithms.h"
#include "common/experiment.h"
#include "common/generate.h"
#include "common/workspace.h"

struct timing {
    struct workspace workspace;
    struct answers answers;
    struct search search;
};

static struct trial prepare(struct timing *timing, const char *name,
                            struct question question, unsigned answer)
{
    question.workspace = &timing->workspace;
    timing->answers = answers_for(question.points.n, answer);
    timing->search = (struct search){find_algorithm(name)->run,
                                     question, &timing->answers};
    return (struct trial){run_search, &timing->search};
}

static void finish(struct timing *timing)
{
    answers_free(&timing->answers);
    workspace_free(&timing->workspace);
}

static void print_kind(const char *kind, uint32_t n, int trials)
{
    enum { WAYS = 5 };
    struct question even = kind_question("uniform", n, 1);
    struct question crowd = kind_question(kind, n, 1);
    struct timing timing[WAYS] = {0};
    struct trial trial[WAYS] = {
        prepare(&timing[0], "row-spans", even, NEAREST),
        prepare(&timing[1], "near-and-far", even, NEAREST | FURTHEST),
        prepare(&timing[2], "by-sample", crowd, NEAREST),
        prepare(&timing[3], "by-sample", crowd, NEAREST | FURTHEST),
        prepare(&timing[4], "adaptive", crowd, NEAREST)};
    time_in_turn(trials, trial, WAYS);
    row_of_times(trial, WAYS, n, "%s\t%u", kind, n);
    for (int k = 0; k < WAYS; k++)
        finish(&timing[k]);
    points_free(&even.points);
    points_free(&crowd.points);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    columns(&e, "name n spans:3 even:3 near:3 both:3 adaptive:3");
    for (int d = 0; d < distribution_count; d++)
        print_kind(distributions[d].name, n, trials);
    return 0;
}
