// Which share of the candidates are false positives, without an event,
// over the length of a step: boxes grow with the motion that they
// capture. Candidates and events for
// each triangle, and what the twelve directions leave to the narrow
// phase.
//
//     false_positives [TRIANGLES]
#include "ch13-contact/experiments/setting.h"

static const double steps[] = {0.0001, 0.001, 0.003, 0.01,
                               0.03,   0.1,   0.3,   1};

static void print_step(double dt, uint32_t triangles)
{
    struct simulation s =
        cloud_of(triangles, false, find_broad_phase("clusters"), dt);
    const struct step_report report = take_step(&s);
    const double n = s.scene.mesh.triangles;
    const double all = (double)report.candidates;
    const double hits = (double)report.hits;
    row("step_%g\t%g\t%.0f\t%.5g\t%.5g\t%.5g\t%.5g\t%.4g\t%.4g",
        10000 * dt, dt, n, all / n,
        (double)(report.paired - report.apart) / n, hits / n,
        (double)report.events / n, (all - hits) / all,
        (double)report.tests.pieces / n);
    simulation_free(&s);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "TRIANGLES", 5000, 1000, 3000000);
    print_header(&e,
                 "name step triangles candidates narrow hits events "
                 "false_positives pieces");
    for (int k = 0; k < COUNT_OF(steps); k++)
        print_step(steps[k], n);
}
