// The partition, and the search by row spans, over
// the number of points in a cell; and the distances computed and the
// points that ask alone, counted and expected.
//
//     fullness [POINTS [TRIALS]]
#include "ch09-row-spans/experiments/expected_spans.h"
#include "ch09-row-spans/row_spans.h"
#include "common/experiment.h"

struct halves {
    struct question question;
    double c;
    struct workspace kept, scratch; // the partition's, and what is free
    struct partition partition;
    struct answers answers;
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
                     &h->answers);
}

static const struct {
    const char *name;
    double c;
} cells[] = {{"c_half", 0.5}, {"c_three_quarters", 0.75},
             {"c_one", 1},    {"c_one_and_a_half", 1.5},
             {"c_two", 2},    {"c_three", 3},
             {"c_four", 4},   {"c_six", 6}};
enum { SIZES = sizeof cells / sizeof *cells };

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    int count = parameter(&e, "TRIALS", 5, 1, MANY);
    struct halves halves[SIZES];
    struct trial trials[2 * SIZES];
    struct question question = uniform_question(WRAPAROUND, n, 1);
    struct answers answers = answers_allocate(n);
    for (int k = 0; k < SIZES; k++) {
        halves[k] = (struct halves){
            .question = question, .c = cells[k].c, .answers = answers};
        halves[k].partition = partition_make(&question, cells[k].c,
                                             RESTORE, &halves[k].kept);
        trials[2 * k] = (struct trial){
            .work = sort, .prepare = sort, .context = &halves[k]};
        trials[2 * k + 1] =
            (struct trial){.work = search, .context = &halves[k]};
    }
    time_in_turn(count, trials, 2 * SIZES);
    columns(&e, "name c distances expected alone alone_expected sort:3 "
                "search:3");
    for (int k = 0; k < SIZES; k++) {
        double c =
            (double)n / grid_cells(&halves[k].partition.sorted.grid);
        struct counts counts = {0};
        question.counts = &counts;
        search_row_spans(&question, &halves[k].partition,
                         &halves[k].scratch, &answers);
        row_of_times(&trials[2 * k], 2, n,
                     "%s\t%g\t%.5g\t%.5g\t%.4g\t%.4g", cells[k].name,
                     cells[k].c, (double)counts.distances / n,
                     expected_shown(c), (double)counts.tasks / n,
                     expected_alone(c));
        workspace_free(&halves[k].scratch);
        workspace_free(&halves[k].kept);
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
