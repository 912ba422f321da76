//> Compare whole algorithms
// See compare.h.
#include "ch03-half-pairs/compare.h"
#include "ch02-all-pairs/timing.h"
#include "common/fail.h"
#include <omp.h>
#include <stdbool.h>
#include <stdlib.h>

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
    struct search *searches = allocate(2 * count, sizeof *searches);
    struct trial *turns = allocate(2 * count, sizeof *turns);
    for (int e = 0; e < 2 * count; e++) {
        const struct version *version = &versions[e / 2];
        bool serial = e % 2 == 0;
        searches[e] = (struct search){
            serial ? version->serial : version->parallel,
            {points,
             {geometry, 1, 1},
             serial ? 1 : omp_get_num_procs()},
            &answers,
        };
        turns[e] =
            (struct trial){.work = run_search, .context = &searches[e]};
    }
    time_in_turn(trials, turns, 2 * count);
    double pairs = (double)points.n * (points.n - 1.0);
    for (int v = 0; v < count; v++) {
        times[v].serial = scaled(turns[2 * v].summary, 1 / pairs);
        times[v].parallel = scaled(turns[2 * v + 1].summary, 1 / pairs);
    }
    free(turns);
    free(searches);
    answers_free(&answers);
}
//<
//<
