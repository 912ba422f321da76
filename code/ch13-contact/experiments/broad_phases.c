// All broad phases over the number of triangles: pairs of boxes looked
// at, candidates, and time, for each triangle. Bodies move, and what a
// broad phase keeps from step to step it may use. And the same beside a
// body of a few giant triangles.
//
//     broad_phases [TRIANGLES [TRIALS]]
#include "ch13-contact/experiments/setting.h"

// What looks at all pairs is left out from then on.
enum { TOO_MANY = 30000 };

static void print_broad(const struct broad_phase *phase,
                        uint32_t triangles, bool giant, int trials)
{
    double ns[MAX_TRIALS];
    struct simulation s = cloud_of(triangles, giant, phase, 0.01);
    for (int trial = -1; trial < trials; trial++) {
        const double time = time_broad(&s);
        if (trial >= 0)
            ns[trial] = time;
        go_on(&s);
    }
    const double n = s.scene.mesh.triangles;
    const struct summary summary = summarize(ns, trials);
    row_begin("%s_%s%u\t%s\t%d\t%u\t%.0f\t%.4g\t%.5g", phase->name,
              giant ? "giant_" : "", triangles, phase->name, giant,
              triangles, n, (double)s.pairs.count / n,
              (double)s.pairs.tested / n);
    row_times(&summary, n);
    row_end();
    simulation_free(&s);
}

static bool is_bearable(const struct broad_phase *phase,
                        uint32_t triangles)
{
    return triangles < TOO_MANY ||
           (strcmp(phase->name, "all-pairs") != 0 &&
            strcmp(phase->name, "scan") != 0);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t max_n =
        parameter(&e, "TRIANGLES", 3000, 1000, 3000000);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    print_header(&e,
                 "name broad giant n triangles candidates tested ns:3");
    for (uint32_t n = 1000; n <= max_n; n = next_size(n))
        for (int row = 0; row < broad_phase_count; row++)
            if (is_bearable(&broad_phases[row], n))
                print_broad(&broad_phases[row], n, false, trials);
    for (int row = 0; row < broad_phase_count; row++)
        if (is_bearable(&broad_phases[row], max_n))
            print_broad(&broad_phases[row], max_n, true, trials);
}
