//> Search where all cells are alike
// The same number of cells and distances twice: uniform points, and a
// lattice with four points in every cell. Whatever takes longer with
// the first is not the arithmetic. Wraparound, one thread, search only.
//
//     lattice [SIDE [TRIALS]]
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/point_by_point.h"
#include "ch04-cell-sort/together.h"
#include "common/argument.h"
#include "common/count.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

enum { SETS = 2, PER_CELL = 4 };

struct set {
    struct question question;
    struct sorted sorted;
    struct answers answers;
};

static void one_by_one(void *context)
{
    struct set *s = context;
    search_sorted(&s->question, &s->sorted, &s->answers);
}

static void all_together(void *context)
{
    struct set *s = context;
    search_together(&s->question, &s->sorted, &s->answers);
}

static struct set make_set(const char *name, uint32_t n)
{
    struct set s = {.question = kind_question(name, n, 1),
                    .answers = answers_allocate(n)};
    s.question.space.geometry = WRAPAROUND;
    s.sorted = sorted_make(&s.question, PER_CELL, cells_sort_alone);
    return s;
}

static void set_free(struct set *s)
{
    sorted_free(&s->sorted);
    answers_free(&s->answers);
    points_free(&s->question.points);
}

static void print_set(const char *name, struct set *s,
                      const struct trial versions[2])
{
    const uint32_t n = s->question.points.n;
    counting_take();
    counting_search_sorted(&s->question, &s->sorted, &s->answers);
    struct counts counts = counting_take();
    printf("%s\t%u\t%.4g\t%.4g", name, n, (double)counts.cells / n,
           (double)counts.distances / n);
    print_summary(&versions[0].summary, n);
    print_summary(&versions[1].summary, n);
    puts("");
}

int main(int argc, char **argv)
{
    static const char *const names[SETS] = {"uniform", "lattice"};
    fail_as("lattice");
    uint32_t side = argument(argc, argv, 1, "SIDE", 320, 2, 30000);
    int trials = argument(argc, argv, 2, "TRIALS", 5, 1, MANY);
    struct set sets[SETS];
    struct trial versions[2 * SETS];
    for (int s = 0; s < SETS; s++) {
        sets[s] = make_set(names[s], side * side);
        versions[2 * s] =
            (struct trial){.work = one_by_one, .context = &sets[s]};
        versions[2 * s + 1] =
            (struct trial){.work = all_together, .context = &sets[s]};
    }
    time_in_turn(trials, versions, 2 * SETS);
    report_provenance(stdout);
    puts("name\tn\tcells\tdistances\tsorted\tsorted_q1\tsorted_q3"
         "\ttogether\ttogether_q1\ttogether_q3");
    for (int s = 0; s < SETS; s++) {
        print_set(names[s], &sets[s], &versions[2 * s]);
        set_free(&sets[s]);
    }
    return 0;
}
//<
