//> Print what the vector units can do
// Nanoseconds an operation on one double, by kind, and a clock cycle.
//
//     rates [TRIALS]
#include "ch02-all-pairs/peak.h"
#include "ch02-all-pairs/timing.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

int main(int argc, char **argv)
{
    fail_as("rates");
    int trials = argument(argc, argv, 1, "TRIALS", 51, 1, MANY);
    struct trial versions[PEAKS];
    peak_versions(versions);
    time_in_turn(trials, versions, PEAKS);

    report_provenance(stdout);
    puts("name\tns\tns_q1\tns_q3");
    for (int peak = 0; peak < PEAKS; peak++) {
        printf("%s", peak_names[peak]);
        print_summary(&versions[peak].summary, peak_operations[peak]);
        puts("");
    }
    return 0;
}
//<
