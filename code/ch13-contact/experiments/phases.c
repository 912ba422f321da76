// What the phases of a step take, over the number of triangles, of
// bodies in motion that are kept apart: nanoseconds for each triangle,
// and which share of the step the broad phase is.
//
//     phases [TRIANGLES [TRIALS]]
#include "ch13-contact/experiments/setting.h"

enum { BEFORE = 10 }; // steps, until some bodies touch

static const char *const names[] = {"clusters", "clusters-prune",
                                    "kd-tree", "cells"};

static void print_phases(const char *name, uint32_t n, int trials)
{
    double ns[PHASES + 1][MAX_TRIALS], sum = 0, broad = 0;
    struct scene scene = {0};
    fill_cloud(&scene, n / TRIANGLES_PER_BODY + 1, 1, 1);
    scene_complete(&scene);
    struct simulation s =
        simulation_of(scene, find_broad_phase(name), 0.05, 1);
    struct step_report report = {0};
    for (int step = 0; step < BEFORE; step++)
        take_step(&s);
    for (int trial = 0; trial < trials; trial++) {
        report = take_step(&s);
        ns[PHASES][trial] = 0;
        for (int phase = 0; phase < PHASES; phase++) {
            ns[phase][trial] = (double)report.ns[phase];
            ns[PHASES][trial] += ns[phase][trial];
        }
        sum += ns[PHASES][trial];
        broad += ns[BROAD][trial];
    }
    const double triangles = s.scene.mesh.triangles;
    row_begin("%s_%u\t%s\t%u\t%.0f\t%.4g\t%.4g\t%.4g\t%.4g", name, n,
              name, n, triangles, (double)report.candidates / triangles,
              (double)(report.paired - report.apart) / triangles,
              (double)report.events / triangles, broad / sum);
    for (int phase = 0; phase <= PHASES; phase++) {
        const struct summary summary = summarize(ns[phase], trials);
        row_times(&summary, triangles);
    }
    row_end();
    simulation_free(&s);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t max_n =
        parameter(&e, "TRIANGLES", 10000, 1000, 3000000);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    print_header(&e, "name broad n triangles candidates narrow events "
                     "broad_share predict:3 capture:3 broad_ns:3 "
                     "narrow_ns:3 handle:3 step:3");
    for (uint32_t n = 1000; n <= max_n; n = next_size(n))
        for (int k = 0; k < COUNT_OF(names); k++)
            print_phases(names[k], n, trials);
}
