// The partition, and the search by row spans, over the number of points
// in a cell; and the distances computed and the points that are queried
// alone, counted and expected.
//     fullness [POINTS [TRIALS]]
#include "ch09-row-spans/experiments/expected_spans.h"
#include "ch09-row-spans/row_spans.h"
#include "common/experiment.h"

struct halves {
    struct question question;
    double c;
    struct workspace kept, scratch; // the partition's, and what is free
    struct partition partition;
    struct answers *answers;
};

static void sort(void *context)
{
    struct halves *h = context;
    struct mark mark = workspace_mark(&h->scratch);
    partition_make(&h->question, h->c, RESTORE, &h->scratch);
    workspace_release(&h->scratch, mark);
}

static void search(void *context)
{
    struct halves *h = context;
    search_row_spans(&h->question, &h->partition, &h->scratch,
                     h->answers);
}

static const struct {
    const char *name;
    double c;
} sizes[] = {{"c_half", 0.5}, {"c_three_quarters", 0.75},
             {"c_one", 1},    {"c_one_and_a_half", 1.5},
             {"c_two", 2},    {"c_three", 3},
             {"c_four", 4},   {"c_six", 6}};
enum { SIZES = COUNT_OF(sizes) };

static void print_size(const char *name, struct halves *h,
                       const struct trial trials[2])
{
    const uint32_t n = h->question.points.n;
    double c = (double)n / grid_cells(&h->partition.sorted.grid);
    struct counts counts = {0};
    h->question.counts = &counts;
    search(h);
    row_of_times(trials, 2, n, "%s\t%g\t%.5g\t%.5g\t%.4g\t%.4g", name,
                 h->c, (double)counts.distances / n, expected_shown(c),
                 (double)counts.tasks / n, expected_alone(c));
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    int count = parameter(&e, "TRIALS", 5, 1, MANY);
    static struct halves halves[SIZES];
    struct trial trials[2 * SIZES];
    struct question question = uniform_question(WRAPAROUND, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    for (int k = 0; k < SIZES; k++) {
        struct halves *h = &halves[k];
        h->question = question;
        h->answers = answers;
        h->c = sizes[k].c;
        h->partition =
            partition_make(&question, h->c, RESTORE, &h->kept);
        trials[2 * k] = (struct trial){sort, h, .prepare = sort};
        trials[2 * k + 1] = (struct trial){search, h};
    }
    time_in_turn(count, trials, 2 * SIZES);
    columns(&e, "name c distances expected alone alone_expected sort:3 "
                "search:3");
    for (int k = 0; k < SIZES; k++)
        print_size(sizes[k].name, &halves[k], &trials[2 * k]);
}
