// Measures what a table of primitives does not: operations on a number
// in a register, and the start of a short loop.
#include "ch08-vector-spiral/experiments/small_prices.h"

// Of sixteen, from the load of a number to its store.
enum { NUMBERS_OPERATED = 1024, OPERATIONS = 16, ROUNDS = 512 };

static void operate(void *context)
{
    double *x = context;
    for (int round = 0; round < ROUNDS; round++)
#pragma omp simd
        for (int i = 0; i < NUMBERS_OPERATED; i++) {
            double y = x[i];
            for (int k = 0; k < OPERATIONS / 2; k++)
                y = y * y + 0.125;
            x[i] = y;
        }
}

double operation_price(int trials)
{
    double x[NUMBERS_OPERATED] = {0};
    struct summary ns = time_trials(trials, operate, x);
    return ns.median / NUMBERS_OPERATED / OPERATIONS / ROUNDS;
}

// Of short loops, of lengths that cannot be foreseen: what they take
// beyond the price of their elements.
struct starts {
    const struct primitives *p;
    uint32_t *length;
};
enum { STARTS = 1 << 16, MOST = 32 };

static void start_loops(void *context)
{
    const struct starts *starts = context;
    double from[MOST] = {0}, to[MOST];
    uint32_t index[MOST], kept[MOST + SPILL];
    uint8_t keep[MOST];
    for (uint32_t i = 0; i < MOST; i++)
        index[i] = i, keep[i] = i & 1;
    for (uint32_t k = 0; k < STARTS; k++) {
        starts->p->gather(to, from, index, starts->length[k]);
        starts->p->pack(kept, index, keep, starts->length[k]);
    }
}

double start_price(const struct primitives *p, int trials,
                   const struct summary near[WORKS])
{
    struct random random = {1};
    struct starts starts = {p, take(STARTS, sizeof(uint32_t))};
    double elements = 0;
    for (uint32_t k = 0; k < STARTS; k++) {
        starts.length[k] = random_bits(&random) % MOST;
        elements += starts.length[k];
    }
    struct summary ns = time_trials(trials, start_loops, &starts);
    return (ns.median - elements * (near[GATHER_IN_ORDER].median +
                                    near[PACK].median)) /
           (2.0 * STARTS);
}
