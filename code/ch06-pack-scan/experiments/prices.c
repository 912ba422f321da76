// Price the primitives, cache by cache.
// Nanoseconds an element of each primitive, with the chosen instruction
// set, on working sets that fit into a cache with room to spare, and on
// one that fits into none. In the first columns, the portable ones in
// the first cache, timed in turn with the chosen.
//     prices [TRIALS [LARGEST]]
#include "ch06-pack-scan/experiments/caches.h"
#include "ch06-pack-scan/experiments/workload.h"

enum { LEVELS = 4 };

// Choose working sets.
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

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    size_t bytes[LEVELS];
    working_sets(bytes,
                 parameter(&e, "LARGEST", 1 << 25, 1 << 16, MANY));
    const struct primitives *chosen = primitives(isa_chosen());
    const struct primitives *both[] = {primitives(PORTABLE), chosen};
    struct summary ns[1 + LEVELS][WORKS];
    price_tables(trials, bytes[0], both, 2, ns);
    for (int level = 1; level < LEVELS; level++)
        price_tables(trials, bytes[level], &chosen, 1, ns + 1 + level);

    print_header(&e, "name isa portable_l1_ns:3 l1_ns:3 l2_ns:3 l3_ns:3"
                     " memory_ns:3");
    for (int work = 0; work < WORKS; work++) {
        row_begin("%s\t%s", work_names[work], isa_names[chosen->isa]);
        for (int c = 0; c <= LEVELS; c++)
            row_times(&ns[c][work], 1);
        row_end();
    }
}
