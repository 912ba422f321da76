// Times a loop of one operation on registers only. Six times eight
// accumulators: twelve vectors of four. A sum or product waits only for
// itself, and a minimum for its neighbor as well, but both began at
// least half a round before.
#include "ch02-all-pairs/experiments/peak.h"
#include "ch02-all-pairs/subtract_fused.h"
#include "common/inlined.h"

enum { WIDE = 8, ROUNDS = 100000 };

static struct registers {
    double a[WIDE], b[WIDE], c[WIDE], d[WIDE], e[WIDE], f[WIDE];
} registers;

INLINED double operate(const char operation, double a, double b,
                       double one)
{
    switch (operation) {
    case '+':
        return a + one;
    case '*':
        return a * one;
    case '<':
        return b < a ? b : a;
    default:
        return subtract_fused(a, one, one);
    }
}

INLINED void operate_all(void *context, const char *const operations)
{
    struct registers *all = context, r = *all;
    const double one = unit;
    for (int round = 0; round < ROUNDS; round++) {
#pragma omp simd
        for (int lane = 0; lane < WIDE; lane++) {
            r.a[lane] =
                operate(operations[0], r.a[lane], r.b[lane], one);
            r.b[lane] =
                operate(operations[1], r.b[lane], r.c[lane], one);
            r.c[lane] =
                operate(operations[2], r.c[lane], r.d[lane], one);
            r.d[lane] =
                operate(operations[3], r.d[lane], r.e[lane], one);
            r.e[lane] =
                operate(operations[4], r.e[lane], r.f[lane], one);
            r.f[lane] =
                operate(operations[5], r.f[lane], r.a[lane], one);
        }
    }
    *all = r;
}

#define PEAK(name, operations)            \
    static void name(void *context)       \
    {                                     \
        operate_all(context, operations); \
    }

PEAK(add, "++++++")
PEAK(multiply, "******")
PEAK(minimum, "<<<<<<")
PEAK(fused, "------")
PEAK(add_multiply, "+*+*+*")
PEAK(add_minimum, "+<+<+<")
PEAK(multiply_minimum, "*<*<*<")
PEAK(all_kinds, "+*<+*<")

static uint64_t chain = 88172645463325252; // anything but 0

static void cycle(void *context)
{
    uint64_t *state = context, x = *state;
    for (int round = 0; round < ROUNDS; round++) { // Marsaglia 2003
        x ^= x << 13;
        x ^= x >> 7;
        x ^= x << 17;
    }
    *state = x;
}

const char *const peak_names[PEAKS] = {
    "add",          "multiply",    "minimum",          "fused",
    "add_multiply", "add_minimum", "multiply_minimum", "all",
    "cycle"};

double peak_operations(enum peak peak)
{
    return (peak == CYCLE ? 6.0 : 6.0 * WIDE) * ROUNDS;
}

void peak_versions(struct trial versions[static PEAKS])
{
    static void (*const work[PEAKS])(void *) = {
        add,         multiply,         minimum,   fused, add_multiply,
        add_minimum, multiply_minimum, all_kinds, cycle};
    for (int peak = 0; peak < PEAKS; peak++)
        versions[peak] = (struct trial){
            .work = work[peak],
            .context = peak == CYCLE ? (void *)&chain : &registers};
}

double peak_limit(const double ns[static PEAKS], struct bill bill)
{
    double fastest = ns[0];
    for (int peak = 0; peak < CYCLE; peak++)
        fastest = fmin(fastest, ns[peak]);
    int products = bill.multiplies + bill.fused;
    double bounds[] = {
        bill.adds * ns[ADD],
        bill.multiplies * ns[MULTIPLY] + bill.fused * ns[FUSED],
        bill.minima * ns[MINIMUM],
        (bill.adds + products) * ns[ADD_MULTIPLY],
        (bill.adds + bill.minima) * ns[ADD_MINIMUM],
        (products + bill.minima) * ns[MULTIPLY_MINIMUM],
        (bill.adds + products + bill.minima) * fastest,
    };
    double limit = 0;
    for (int k = 0; k < COUNT_OF(bounds); k++)
        limit = fmax(limit, bounds[k]);
    return limit;
}
