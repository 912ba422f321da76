// The mean nearest distance in both geometries, for 100, 200, 400, ...
// uniform points, in units of 1 / (2 sqrt n). Small sets are repeated
// until a set and its repetitions have about as many points as the
// largest.
//     growth [MOST]
#include "ch02-all-pairs/tiles.h"
#include "common/experiment.h"

static double mean_nearest(enum geometry geometry, uint32_t n, int seed)
{
    struct question question = uniform_question(geometry, n, seed);
    struct answers *answers = new_answers(n, BOTH);
    question.threads = n < 5000 ? 1 : omp_get_num_procs();
    tiles(&question, answers);
    double sum = 0;
    for (uint32_t i = 0; i < n; i++)
        sum += sqrt(answers->nearest2[i]);
    forget();
    return sum / n * 2 * sqrt(n);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 12800, 100, MANY);
    print_header(&e, "name n bounded wrapped");
    for (uint32_t n = 100; n <= most; n *= 2) {
        double bounded = 0, wrapped = 0;
        const int sets = 2 * most / n;
        for (int set = 1; set <= sets; set++) {
            bounded += mean_nearest(STANDARD, n, set);
            wrapped += mean_nearest(WRAPAROUND, n, set);
        }
        row("mean_%u\t%u\t%.5g\t%.5g", n, n, bounded / sets,
            wrapped / sets);
    }
}
