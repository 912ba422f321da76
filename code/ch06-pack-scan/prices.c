//> Price the primitives, cache by cache
// Nanoseconds an element of each primitive, with the chosen instruction
// set, on working sets that fit into a cache with room to spare, and on
// one that fits into none. In the first columns, the portable ones in
// the first cache, timed in turn with the chosen.
//
//     prices [TRIALS [LARGEST]]
#include "ch02-all-pairs/timing.h"
#include "ch06-pack-scan/caches.h"
#include "ch06-pack-scan/workload.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

enum { LEVELS = 4 };

//> Choose working sets
static void working_sets(size_t bytes[static LEVELS], size_t largest)
{
    struct caches caches = caches_of_machine();
    bytes[0] = caches.l1 / 2;
    bytes[1] = caches.l2 / 2;
    bytes[2] = caches.l3 / 8; // others share it
    bytes[3] = caches.l3 * 4;
    for (int level = 0; level < LEVELS; level++)
        bytes[level] = bytes[level] < largest ? bytes[level] : largest;
}
//<

int main(int argc, char **argv)
{
    fail_as("prices");
    int trials = argument(argc, argv, 1, "TRIALS", 3, 1, MANY);
    size_t bytes[LEVELS];
    working_sets(bytes, argument(argc, argv, 2, "LARGEST", 1 << 25,
                                 1 << 16, MANY));
    const struct primitives *chosen = primitives(isa_chosen());
    const struct primitives *both[] = {primitives(PORTABLE), chosen};
    struct summary ns[1 + LEVELS][WORKS];
    price_tables(trials, bytes[0], both, 2, ns);
    for (int level = 1; level < LEVELS; level++)
        price_tables(trials, bytes[level], &chosen, 1, ns + 1 + level);

    report_provenance(stdout);
    printf("name\tisa");
    static const char *const columns[] = {"portable_l1", "l1", "l2",
                                          "l3", "memory"};
    for (int c = 0; c <= LEVELS; c++)
        printf("\t%s_ns\t%s_ns_q1\t%s_ns_q3", columns[c], columns[c],
               columns[c]);
    puts("");
    for (int work = 0; work < WORKS; work++) {
        printf("%s\t%s", work_names[work], isa_names[chosen->isa]);
        for (int c = 0; c <= LEVELS; c++)
            print_summary(&ns[c][work], 1);
        puts("");
    }
    return 0;
}
//<
