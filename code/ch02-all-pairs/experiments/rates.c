// Nanoseconds an operation on one double, by kind, and a clock cycle.
//     rates [TRIALS]
#include "ch02-all-pairs/experiments/peak.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    int trials = parameter(&e, "TRIALS", 51, 1, MANY);
    struct trial versions[PEAKS];
    peak_versions(versions);
    time_in_turn(trials, versions, PEAKS);
    print_header(&e, "name ns:3");
    for (int peak = 0; peak < PEAKS; peak++)
        row_of_times(&versions[peak], 1, peak_operations(peak), "%s",
                     peak_names[peak]);
}
