// The mean nearest distance in both geometries, for 100, 200, 400, ...
// uniform points, in units of 1 / (2 sqrt n). Small sets are repeated
// until a set and its repetitions have about as many points as the
// largest.
//
//     growth [MOST]
#include "ch02-all-pairs/tiles.h"
#include "common/experiment.h"
#include <omp.h>

static double mean_nearest(const struct question *question,
                           struct answers *answers)
{
    const uint32_t n = question->points.n;
    tiles(question, answers);
    double sum = 0;
    for (uint32_t i = 0; i < n; i++)
        sum += sqrt(answers->nearest2[i]);
    return sum / n * 2 * sqrt(n);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 12800, 100, MANY);

    columns(&e, "name n bounded wrapped");
    for (uint64_t n = 100; n <= most; n *= 2) {
        struct answers answers = answers_allocate(n);
        double sum[2] = {0};
        uint32_t sets = 2 * most / n;
        for (uint32_t set = 0; set < sets; set++) {
            struct question question =
                uniform_question(STANDARD, n, set + 1);
            question.threads = n < 5000 ? 1 : omp_get_num_procs();
            for (int g = 0; g < 2; g++) {
                question.space.geometry = g ? WRAPAROUND : STANDARD;
                sum[g] += mean_nearest(&question, &answers);
            }
            points_free(&question.points);
        }
        answers_free(&answers);
        row("mean_%u\t%u\t%.5g\t%.5g", (unsigned)n, (unsigned)n,
            sum[0] / sets, sum[1] / sets);
    }
    return 0;
}
