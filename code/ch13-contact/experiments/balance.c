// Who has the contacts? A pile, whose triangles are dealt out to
// threads in the order of the mesh, or whose candidate pairs are, in
// equal parts: the work of the thread that has most, in units of the
// mean. The work of a pair is counted: one for the directions that tell
// it apart, otherwise its tests and the pieces of their halving.
//
//     balance [BODIES [STEPS]]
#include "ch13-contact/experiments/setting.h"
#include "ch13-contact/separating_axis.h"
#include "common/chunk.h"
#include "common/min_max.h"

static const int threads[] = {2, 4, 8, 16, 32, 64};

static double work_of(const struct simulation *s, struct pair pair)
{
    struct event event[MAX_EVENTS];
    struct event_counts counts = {0};
    const struct moving_triangle p =
        moving_triangle_of(&s->scene, pair.one);
    const struct moving_triangle q =
        moving_triangle_of(&s->scene, pair.other);
    if (has_separating_axis(&p, &q, s->tolerance))
        return 1;
    triangle_events(&p, &q, s->tolerance, event, &counts);
    return 1 + (double)counts.tests + (double)counts.pieces;
}

// Of so many parts, each from one border to the next, the largest sum,
// in units of the mean. With triangles, parts have as many triangles,
// otherwise as many pairs.
static double imbalance(const struct simulation *s, const double *work,
                        int parts, bool triangles)
{
    double largest = 0, all = 0;
    for (int k = 0; k < parts; k++) {
        const uint32_t n = triangles ? s->scene.mesh.triangles
                                     : (uint32_t)s->pairs.count;
        const uint32_t begin = chunk_begin(n, k, parts);
        const uint32_t end = chunk_begin(n, k + 1, parts);
        const uint64_t first =
            triangles ? s->pairs.start[begin] : begin;
        const uint64_t last = triangles ? s->pairs.start[end] : end;
        double sum = 0;
        for (uint64_t p = first; p < last; p++)
            sum += work ? work[p] : 1;
        largest = MAX(largest, sum);
        all += sum;
    }
    return all > 0 ? largest * parts / all : 1;
}

// Runs of 64 pairs, each to the thread that is free first.
static double imbalance_dynamic(const struct simulation *s,
                                const double *work, int parts)
{
    enum { RUN = 64 };
    double busy[64] = {0}, all = 0, largest = 0;
    for (uint64_t p = 0; p < s->pairs.count; p += RUN) {
        int first = 0;
        for (int k = 1; k < parts; k++)
            first = busy[k] < busy[first] ? k : first;
        for (uint64_t q = p; q < MIN(p + RUN, s->pairs.count); q++) {
            busy[first] += work[q];
            all += work[q];
        }
    }
    for (int k = 0; k < parts; k++)
        largest = MAX(largest, busy[k]);
    return all > 0 ? largest * parts / all : 1;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t bodies = parameter(&e, "BODIES", 60, 1, 100000);
    const uint32_t steps = parameter(&e, "STEPS", 150, 1, MANY);
    const struct built_in *pile = find_built_in("pile");
    struct simulation s =
        simulation_of(build_scene(pile, bodies, 1),
                      find_broad_phase("clusters"), pile->dt, 1);
    s.sleepers.patience = 0; // all pairs are tested
    for (uint32_t step = 0; step < steps; step++)
        take_step(&s);
    time_broad(&s); // the next step, as far as its candidates
    double *work = take(s.pairs.count + 1, sizeof *work);
    for (uint64_t p = 0; p < s.pairs.count; p++)
        work[p] = work_of(&s, s.pairs.pair[p]);
    print_header(&e,
                 "name threads triangles candidates pairs_by_triangle "
                 "work_by_triangle work_by_pair work_by_runs");
    for (int k = 0; k < COUNT_OF(threads); k++)
        row("threads_%d\t%d\t%u\t%.0f\t%.4g\t%.4g\t%.4g\t%.4g",
            threads[k], threads[k], s.scene.mesh.triangles,
            (double)s.pairs.count,
            imbalance(&s, NULL, threads[k], true),
            imbalance(&s, work, threads[k], true),
            imbalance(&s, work, threads[k], false),
            imbalance_dynamic(&s, work, threads[k]));
    simulation_free(&s);
}
