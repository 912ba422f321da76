// All steps of the ladder in turn, in both geometries, and among them
// the vector units' peaks: what the steps achieve and what could be
// achieved, measured in one run.
//     climb [POINTS [ROWS [TRIALS]]]
#include "ch02-all-pairs/experiments/peak.h"
#include "ch02-all-pairs/experiments/rows.h"
#include "ch02-all-pairs/ladder.h"

// The bill's limit at the medians and the quartiles of the peaks.
static void print_limit(const struct trial *peaks, struct bill bill)
{
    double median[PEAKS], q1[PEAKS], q3[PEAKS];
    for (int peak = 0; peak < PEAKS; peak++) {
        struct summary ns = peaks[peak].summary;
        median[peak] = ns.median / peak_operations(peak);
        q1[peak] = ns.q1 / peak_operations(peak);
        q3[peak] = ns.q3 / peak_operations(peak);
    }
    row_cells("\t%.4g\t%.4g\t%.4g", peak_limit(median, bill),
              peak_limit(q1, bill), peak_limit(q3, bill));
}

// A subtraction is an addition, a maximum a minimum. Two of the
// subtractions can be handed over to the multipliers.
static void print_limits(const struct trial *peaks)
{
    row_begin("limit");
    print_limit(peaks, (struct bill){3, 2, 0, 2});
    print_limit(peaks, (struct bill){6, 4, 0, 6});
    row_end();
    row_begin("limit_tiles");
    print_limit(peaks, (struct bill){1, 2, 2, 2});
    print_limit(peaks, (struct bill){4, 4, 2, 6});
    row_end();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 8192, 2, MANY);
    uint32_t rows = parameter(&e, "ROWS", 512, 1, n);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    const int climbed = 2 * step_count;
    struct trial *versions = take(climbed + PEAKS, sizeof *versions);
    for (int v = 0; v < climbed; v++) {
        question.space.geometry = v % 2 ? WRAPAROUND : STANDARD;
        versions[v] =
            rows_trial(steps[v / 2].rows, &question, answers, rows);
    }
    peak_versions(versions + climbed);
    time_in_turn(trials, versions, climbed + PEAKS);
    print_header(&e, "name standard:3 wraparound:3");
    for (int v = 0; v < climbed; v += 2)
        row_of_times(&versions[v], 2, (double)rows * (n - 1), "%s",
                     steps[v / 2].name);
    print_limits(versions + climbed);
}
