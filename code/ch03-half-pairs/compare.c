//> Compare whole algorithms
// See compare.h.
#include "ch03-half-pairs/compare.h"
#include "common/fail.h"
#include "common/generate.h"
#include <omp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

struct entry {
    search_function *search;
    struct question question;
    struct answers *answers;
};

static void run_entry(void *context)
{
    struct entry *entry = context;
    entry->search(&entry->question, entry->answers);
}

static struct summary scaled(struct summary s, double factor)
{
    return (struct summary){s.min * factor, s.q1 * factor,
                            s.median * factor, s.q3 * factor,
                            s.max * factor};
}

//> Time all versions in turn
void compare(struct points points, enum geometry geometry, int trials,
             const struct version *versions, int count,
             struct times *times)
{
    struct answers answers = answers_allocate(points.n);
    struct entry *entries = allocate(2 * count, sizeof *entries);
    struct trial *turns = allocate(2 * count, sizeof *turns);
    for (int e = 0; e < 2 * count; e++) {
        const struct version *version = &versions[e / 2];
        bool serial = e % 2 == 0;
        entries[e] = (struct entry){
            serial ? version->serial : version->parallel,
            {points,
             {geometry, 1, 1},
             serial ? 1 : omp_get_num_procs()},
            &answers,
        };
        turns[e] =
            (struct trial){.work = run_entry, .context = &entries[e]};
    }
    time_in_turn(trials, turns, 2 * count);
    double pairs = (double)points.n * (points.n - 1.0);
    for (int v = 0; v < count; v++) {
        times[v].serial = scaled(turns[2 * v].summary, 1 / pairs);
        times[v].parallel = scaled(turns[2 * v + 1].summary, 1 / pairs);
    }
    free(turns);
    free(entries);
    answers_free(&answers);
}
//<

struct points uniform_points(uint32_t n)
{
    return generate(find_distribution("uniform"), n, 1);
}

void print_times(const struct summary *summary)
{
    printf("\t%.4g\t%.4g\t%.4g", summary->median, summary->q1,
           summary->q3);
}
//<
