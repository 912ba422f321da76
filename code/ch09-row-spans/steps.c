//> Take one step at a time
// The search alone, from chapter 4's through indices to eight points
// together: every step in turn on the same points, in the order of the
// cells, with the distances that each computes and how many points ask
// alone.
//
//     steps [POINTS [TRIALS]]
#include "algorithms.h"
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/point_by_point.h"
#include "ch04-cell-sort/together.h"
#include "ch09-row-spans/carry.h"
#include "ch09-row-spans/keep.h"
#include "ch09-row-spans/portable_spans.h"
#include "ch09-row-spans/row_spans.h"
#include "common/argument.h"
#include "common/count.h"
#include "common/fail.h"
#include "common/report.h"

//> Hold what all steps work on
enum step {
    INDICES,
    SORTED,
    SPANS,
    VECTORS,
    SKIP_ROWS,
    FOUR,
    SIFTED,
    FEWER,
    STEPS
};

struct steps {
    struct question question;
    struct carried two, fewer; // two in a cell, and as the table has it
    struct answers answers;
};

static void by_indices(void *context)
{
    struct steps *s = context;
    search_indices(&s->question, &s->two.sorted.grid,
                   &s->two.sorted.cells, s->two.sorted.cells.point,
                   &s->answers);
}

static void by_sorted(void *context)
{
    struct steps *s = context;
    search_sorted(&s->question, &s->two.sorted, &s->answers);
}

static void by_spans(void *context)
{
    struct steps *s = context;
    portable_spans(&s->question, &s->two.sorted, ALONE, NULL, 0,
                   s->question.points.n, &s->answers);
}

static void by_vectors(void *context)
{
    struct steps *s = context;
    search_row_spans(&s->question, &s->two, ALONE, &s->answers);
}

static void by_skipping(void *context)
{
    struct steps *s = context;
    search_row_spans(&s->question, &s->two, SKIPPING, &s->answers);
}

static void by_four(void *context)
{
    struct steps *s = context;
    search_together(&s->question, &s->two.sorted, &s->answers);
}

static void by_sifting(void *context)
{
    struct steps *s = context;
    search_row_spans(&s->question, &s->two, TOGETHER, &s->answers);
}

static void by_fewer(void *context)
{
    struct steps *s = context;
    search_row_spans(&s->question, &s->fewer, TOGETHER, &s->answers);
}
//<

//> Count a step
// Chapter 4's searches by points compute as many distances as they find
// points in the blocks, which is what spans find, too. Its four that
// ask together are counted as the row of the table.
static struct counts count_step(struct steps *s, enum step step)
{
    if (step == FOUR)
        return count_operations(find_algorithm("cells"), &s->question,
                                &s->answers);
    enum manner manner = step == SKIP_ROWS  ? SKIPPING
                         : step < SKIP_ROWS ? ALONE
                                            : TOGETHER;
    counting_take();
    counting_search_row_spans(&s->question,
                              step == FEWER ? &s->fewer : &s->two,
                              manner, &s->answers);
    return counting_take();
}
//<

int main(int argc, char **argv)
{
    fail_as("steps");
    memory_keep();
    static const struct {
        const char *name;
        void (*work)(void *);
    } steps[STEPS] = {
        [INDICES] = {"indices", by_indices},
        [SORTED] = {"sorted", by_sorted},
        [SPANS] = {"spans", by_spans},
        [VECTORS] = {"vectors", by_vectors},
        [SKIP_ROWS] = {"skipping", by_skipping},
        [FOUR] = {"four", by_four},
        [SIFTED] = {"sifted", by_sifting},
        [FEWER] = {"fewer", by_fewer},
    };
    uint32_t n = argument(argc, argv, 1, "POINTS", 100000, 2, MANY);
    int count = argument(argc, argv, 2, "TRIALS", 5, 1, MANY);
    struct steps s = {.question = uniform_question(STANDARD, n, 1),
                      .answers = answers_allocate(n)};
    s.two = carry_points(&s.question, POINTS_PER_CELL);
    s.fewer = carry_points(&s.question, POINTS_PER_SPAN_CELL);
    struct trial trials[STEPS];
    for (int k = 0; k < STEPS; k++)
        trials[k] =
            (struct trial){.work = steps[k].work, .context = &s};
    time_in_turn(count, trials, STEPS);
    report_provenance(stdout);
    puts("name\tn\tdistances\talone\tns\tns_q1\tns_q3");
    for (int k = 0; k < STEPS; k++) {
        struct counts counts = count_step(&s, k);
        printf("%s\t%u\t%.5g\t%.4g", steps[k].name, n,
               (double)counts.distances / n, (double)counts.tasks / n);
        print_summary(&trials[k].summary, n);
        puts("");
    }
    carried_free(&s.fewer);
    carried_free(&s.two);
    answers_free(&s.answers);
    points_free(&s.question.points);
    return 0;
}
//<
