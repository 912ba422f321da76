// The same number of cells and distances twice: uniform points, and a
// lattice with four points in every cell. Whatever takes longer with
// the first is not the arithmetic. Wraparound, one thread, search only.
//
//     lattice [SIDE [TRIALS]]
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/experiment.h"

enum { SETS = 2, PER_CELL = 4 };

struct set {
    struct question question;
    struct sorted sorted;
    struct answers answers;
};

static void point_by_point(void *context)
{
    struct set *s = context;
    search_sorted(&s->question, &s->sorted, &s->answers);
}

static void in_batches(void *context)
{
    struct set *s = context;
    search_batches(&s->question, &s->sorted, &s->answers);
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
    struct counts counts = {0};
    s->question.counts = &counts;
    search_sorted(&s->question, &s->sorted, &s->answers);
    row_begin("%s\t%u\t%.4g\t%.4g", name, n, (double)counts.cells / n,
              (double)counts.distances / n);
    row_times(&versions[0].summary, n);
    row_times(&versions[1].summary, n);
    row_end();
}

int main(int argc, char **argv)
{
    static const char *const names[SETS] = {"uniform", "lattice"};
    struct experiment e = experiment_begin(argc, argv);
    uint32_t side = parameter(&e, "SIDE", 320, 2, 30000);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct set sets[SETS];
    struct trial versions[2 * SETS];
    for (int s = 0; s < SETS; s++) {
        sets[s] = make_set(names[s], side * side);
        versions[2 * s] =
            (struct trial){.work = point_by_point, .context = &sets[s]};
        versions[2 * s + 1] =
            (struct trial){.work = in_batches, .context = &sets[s]};
    }
    time_in_turn(trials, versions, 2 * SETS);
    columns(&e, "name n cells distances sorted:3 batches:3");
    for (int s = 0; s < SETS; s++) {
        print_set(names[s], &sets[s], &versions[2 * s]);
        set_free(&sets[s]);
    }
    return 0;
}
