// The latency of an operation, in cycles: a chain in which each step
// needs the result of the one before, beside a chain of operations of
// one cycle each. The last one passes its result through memory, as a
// loop must that calls a function in every turn.
//     latency [TRIALS]
#include "ch02-all-pairs/experiments/peak.h"
#include "common/min_max.h"

enum { WIDE = 8, VALUES = 64, STEPS = 100000 };

static struct registers {
    double a[WIDE], b[WIDE];
} registers;

static double values[VALUES][WIDE];

#define CHAIN(name, operation)                   \
    static void name(void *context)              \
    {                                            \
        struct registers *all = context;         \
        double a = all->a[0], b = all->b[0];     \
        for (int step = 0; step < STEPS; step++) \
            a = a operation b;                   \
        all->a[0] = a;                           \
    }

CHAIN(add, +)
CHAIN(multiply, *)
CHAIN(divide, /)

// In lanes, so that it is an instruction and not a jump.
static void minimum(void *context)
{
    struct registers *all = context, r = *all;
    for (int step = 0; step < STEPS; step++) {
        const double *value = values[(unsigned)step % VALUES];
#pragma omp simd
        for (int lane = 0; lane < WIDE; lane++)
            r.a[lane] = MIN(value[lane], r.a[lane]);
    }
    *all = r;
}

static volatile double memory; // stored and loaded whenever it is named

static void stored(void *context)
{
    struct registers *all = context;
    double a = all->a[0];
    for (int step = 0; step < STEPS; step++) {
        memory = a;
        a = memory;
    }
    all->a[0] = a;
}

static const struct {
    const char *name;
    void (*work)(void *);
} chains[] = {{"latency_add", add},
              {"latency_multiply", multiply},
              {"latency_minimum", minimum},
              {"latency_divide", divide},
              {"latency_stored", stored}};
enum { CHAINS = COUNT_OF(chains) };

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    int trials = parameter(&e, "TRIALS", 101, 1, MANY);
    struct trial peaks[PEAKS], versions[CHAINS + 1];
    peak_versions(peaks);
    for (int c = 0; c < CHAINS; c++)
        versions[c] = (struct trial){chains[c].work, &registers};
    versions[CHAINS] = peaks[CYCLE];
    for (int k = 0; k < WIDE; k++)
        registers.a[k] = registers.b[k] = 1;
    time_in_turn(trials, versions, CHAINS + 1);
    double cycle =
        versions[CHAINS].summary.median / peak_operations(CYCLE);
    print_header(&e, "name cycles:3");
    for (int c = 0; c < CHAINS; c++)
        row_of_times(&versions[c], 1, STEPS * cycle, "%s",
                     chains[c].name);
}
