//> Vary how full a cell is, once more
// The sort that carries the points, and the search by row spans, over
// the number of points in a cell; and the distances computed and the
// points that ask alone, counted and expected.
//
//     fullness [POINTS [TRIALS]]
#include "ch02-all-pairs/timing.h"
#include "ch09-row-spans/carry.h"
#include "ch09-row-spans/expected_spans.h"
#include "ch09-row-spans/keep.h"
#include "ch09-row-spans/row_spans.h"
#include "common/argument.h"
#include "common/count.h"
#include "common/fail.h"
#include "common/report.h"

//> Time both halves
struct halves {
    struct question question;
    double c;
    struct carried carried;
    struct answers answers;
};

static void sort(void *context)
{
    struct halves *h = context;
    struct carried carried = carry_points(&h->question, h->c);
    carried_free(&carried);
}

static void search(void *context)
{
    struct halves *h = context;
    search_row_spans(&h->question, &h->carried, TOGETHER, &h->answers);
}
//<

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
    fail_as("fullness");
    memory_keep();
    uint32_t n = argument(argc, argv, 1, "POINTS", 100000, 2, MANY);
    int count = argument(argc, argv, 2, "TRIALS", 5, 1, MANY);
    struct halves halves[SIZES];
    struct trial trials[2 * SIZES];
    struct question question = uniform_question(WRAPAROUND, n, 1);
    struct answers answers = answers_allocate(n);
    for (int k = 0; k < SIZES; k++) {
        halves[k] = (struct halves){question, cells[k].c,
                                    carry_points(&question, cells[k].c),
                                    answers};
        trials[2 * k] = (struct trial){
            .work = sort, .prepare = sort, .context = &halves[k]};
        trials[2 * k + 1] =
            (struct trial){.work = search, .context = &halves[k]};
    }
    time_in_turn(count, trials, 2 * SIZES);
    report_provenance(stdout);
    puts("name\tc\tdistances\texpected\talone\talone_expected"
         "\tsort\tsort_q1\tsort_q3\tsearch\tsearch_q1\tsearch_q3");
    for (int k = 0; k < SIZES; k++) {
        double c =
            (double)n / grid_cells(&halves[k].carried.sorted.grid);
        counting_take();
        counting_search_row_spans(&question, &halves[k].carried,
                                  TOGETHER, &answers);
        struct counts counts = counting_take();
        printf("%s\t%g\t%.5g\t%.5g\t%.4g\t%.4g", cells[k].name,
               cells[k].c, (double)counts.distances / n,
               expected_shown(c), (double)counts.tasks / n,
               expected_alone(c));
        print_summary(&trials[2 * k].summary, n);
        print_summary(&trials[2 * k + 1].summary, n);
        puts("");
        carried_free(&halves[k].carried);
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
//<
