// The partition, and the search by row spans, over the number of points
// in a cell; and the distances computed and the points that are queried
// alone, counted and expected.
//     fullness [POINTS [TRIALS]]
#include "ch09-row-spans/experiments/expected_spans.h"
#include "ch09-row-spans/row_spans.h"
#include "common/experiment.h"

struct stages {
    struct question question;
    double c;
    struct workspace kept, scratch; // the partition's, and what is free
    struct partition partition;
    struct answers *answers;
};

static void sort(void *context)
{
    struct stages *s = context;
    struct mark mark = workspace_mark(&s->scratch);
    partition_make(&s->question, s->c, RESTORE, &s->scratch);
    workspace_release(&s->scratch, mark);
}

static void search(void *context)
{
    struct stages *s = context;
    search_row_spans(&s->question, &s->partition, &s->scratch,
                     s->answers);
}

static const struct {
    const char *name;
    double c;
} sizes[] = {{"c_half", 0.5}, {"c_three_quarters", 0.75},
             {"c_one", 1},    {"c_one_and_a_half", 1.5},
             {"c_two", 2},    {"c_three", 3},
             {"c_four", 4},   {"c_six", 6}};
enum { SIZES = COUNT_OF(sizes) };

static void print_size(const char *name, struct stages *s,
                       const struct trial trials[2])
{
    const uint32_t n = s->question.points.n;
    double c = (double)n / grid_cells(&s->partition.sorted.grid);
    struct counts counts = {0};
    s->question.counts = &counts;
    search(s);
    row_of_times(trials, 2, n, "%s\t%g\t%.5g\t%.5g\t%.4g\t%.4g", name,
                 s->c, (double)counts.distances / n,
                 expected_candidates(c), (double)counts.exact / n,
                 expected_exact(c));
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    int count = parameter(&e, "TRIALS", 5, 1, MANY);
    static struct stages stages[SIZES];
    struct trial trials[2 * SIZES];
    struct question question = uniform_question(WRAPAROUND, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    for (int k = 0; k < SIZES; k++) {
        struct stages *s = &stages[k];
        s->question = question;
        s->answers = answers;
        s->c = sizes[k].c;
        s->partition =
            partition_make(&question, s->c, RESTORE, &s->kept);
        trials[2 * k] = (struct trial){sort, s, .prepare = sort};
        trials[2 * k + 1] = (struct trial){search, s};
    }
    time_in_turn(count, trials, 2 * SIZES);
    print_header(
        &e, "name c distances expected exact exact_expected sort:3 "
            "search:3");
    for (int k = 0; k < SIZES; k++)
        print_size(sizes[k].name, &stages[k], &trials[2 * k]);
}
