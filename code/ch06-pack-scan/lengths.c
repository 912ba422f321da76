//> Price the primitives, length by length
// Nanoseconds an element of each primitive against its working set, in
// portable C and with the chosen instruction set.
//
//     lengths [TRIALS [LARGEST]]
#include "ch02-all-pairs/timing.h"
#include "ch06-pack-scan/caches.h"
#include "ch06-pack-scan/workload.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

int main(int argc, char **argv)
{
    fail_as("lengths", NULL);
    int trials = argument(argc, argv, 1, "TRIALS", 3, 1, MANY);
    size_t largest =
        argument(argc, argv, 2, "LARGEST", 1 << 24, 1 << 12, MANY);
    const struct primitives *tables[] = {primitives(PORTABLE),
                                         primitives(isa_chosen())};
    struct caches caches = caches_of_machine();
    report_provenance(stdout);
    puts("primitive\tbytes\tn\tl1\tl2\tl3"
         "\tportable_ns\tportable_ns_q1\tportable_ns_q3"
         "\tvector_ns\tvector_ns_q1\tvector_ns_q3");
    for (int work = 0; work < WORKS; work++)
        for (size_t bytes = 1 << 12; bytes <= largest; bytes *= 2) {
            struct workload workload = workload_make(work, bytes);
            struct summary prices[2];
            workload_price(&workload, trials, tables, 2, prices);
            printf("%s\t%zu\t%u\t%zu\t%zu\t%zu", work_names[work],
                   bytes, workload.n, caches.l1, caches.l2, caches.l3);
            print_summary(&prices[0], 1);
            print_summary(&prices[1], 1);
            puts("");
            workload_free(&workload);
        }
    return 0;
}
//<
