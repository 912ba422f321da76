// Build anew or update? Broad phases that keep what they have from step
// to step, beside those that do not, over the length of a step: time
// and work for each triangle, after several steps.
//
//     update [TRIANGLES [TRIALS]]
#include "ch13-contact/experiments/setting.h"

enum { BEFORE = 20 };

static const char *const names[] = {
    "kd-tree",    "kd-tree-anew",    "projection", "sweep",
    "sweep-kept", "sweep-and-prune", "clusters",   "clusters-prune"};

// Bodies go so far in a step, at most, in units of their size.
static const double steps[] = {0.001, 0.01, 0.1, 1};

static void print_update(const struct broad_phase *phase, double dt,
                         uint32_t triangles, int trials)
{
    double ns[MAX_TRIALS];
    struct simulation s = cloud_of(triangles, false, phase, dt);
    for (int step = -BEFORE; step < trials; step++) {
        const double time = time_broad(&s);
        if (step >= 0)
            ns[step] = time;
        go_on(&s);
    }
    const double n = s.scene.mesh.triangles;
    const struct summary summary = summarize(ns, trials);
    row_begin("%s_step_%g\t%s\t%g\t%.0f\t%.4g\t%.5g", phase->name,
              1000 * dt, phase->name, dt, n, (double)s.pairs.count / n,
              (double)s.pairs.tested / n);
    row_times(&summary, n);
    row_end();
    simulation_free(&s);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "TRIANGLES", 3000, 1000, 3000000);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    print_header(&e,
                 "name broad step triangles candidates tested ns:3");
    for (int k = 0; k < COUNT_OF(names); k++)
        for (int step = 0; step < COUNT_OF(steps); step++)
            print_update(find_broad_phase(names[k]), steps[step], n,
                         trials);
}
