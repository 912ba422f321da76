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

//> Price every primitive at one length
static void print_prices(size_t bytes, int trials)
{
    const struct caches caches = caches_of_machine();
    const struct primitives *both[] = {primitives(PORTABLE),
                                       primitives(isa_chosen())};
    struct summary ns[2][WORKS];
    price_tables(trials, bytes, both, 2, ns);
    for (int work = 0; work < WORKS; work++) {
        printf("%s\t%zu\t%zu\t%zu\t%zu", work_names[work], bytes,
               caches.l1, caches.l2, caches.l3);
        print_summary(&ns[0][work], 1);
        print_summary(&ns[1][work], 1);
        puts("");
    }
}
//<

int main(int argc, char **argv)
{
    fail_as("lengths");
    int trials = argument(argc, argv, 1, "TRIALS", 3, 1, MANY);
    size_t largest =
        argument(argc, argv, 2, "LARGEST", 1 << 24, 1 << 12, MANY);
    report_provenance(stdout);
    puts("primitive\tbytes\tl1\tl2\tl3"
         "\tportable_ns\tportable_ns_q1\tportable_ns_q3"
         "\tvector_ns\tvector_ns_q1\tvector_ns_q3");
    for (size_t bytes = 1 << 12; bytes <= largest; bytes *= 2)
        print_prices(bytes, trials);
    return 0;
}
//<
