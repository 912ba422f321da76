// Every version is run on one thread and on all processors, all in
// turn, into the same answers.
#include "ch03-half-pairs/experiments/compare.h"
#include "common/allocate.h"
#include "common/experiment.h"
#include <omp.h>
#include <stdbool.h>
#include <stdlib.h>

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
    for (int v = 0; v < count; v++)
        times[v] = (struct times){turns[2 * v].summary,
                                  turns[2 * v + 1].summary};
    free(turns);
    free(searches);
    answers_free(&answers);
}
