//> Price a primitive
// See workload.h.
#include "ch06-pack-scan/workload.h"
#include "common/fail.h"
#include "common/random.h"
#include <stdbool.h>
#include <stdlib.h>

//> Know what a primitive touches
const char *const work_names[WORKS] = {"elementwise",
                                       "gather_in_order",
                                       "gather_at_random",
                                       "gather32_in_order",
                                       "gather32_at_random",
                                       "scatter_in_order",
                                       "scatter_at_random",
                                       "scan",
                                       "pack"};

static const int bytes_an_element[WORKS] = {24, 20, 20, 12, 12,
                                            20, 20, 8,  9};

static bool at_random(enum work work)
{
    return work == GATHER_AT_RANDOM || work == GATHER32_AT_RANDOM ||
           work == SCATTER_AT_RANDOM;
}
//<

//> Fill the arrays of a workload
static void fill(struct workload *w)
{
    struct random random = {w->n};
    for (uint32_t i = 0; i < w->n; i++) {
        w->a[i] = w->b[i] = w->to[i] = i;
        w->index[i] = i;
        w->a32[i] = w->to32[i] = i % 4;
        w->keep[i] = random_bits(&random) & 1;
    }
    for (uint32_t i = w->n; at_random(w->work) && i > 1; i--) {
        uint32_t j = random_bits(&random) % i, swapped = w->index[j];
        w->index[j] = w->index[i - 1];
        w->index[i - 1] = swapped;
    }
}

struct workload workload_make(enum work work, size_t bytes)
{
    enum { ELEMENTS = 1 << 20 }; // of a trial, at least
    uint32_t n = bytes / bytes_an_element[work];
    struct workload w = {
        .work = work,
        .n = n,
        .rounds = n < ELEMENTS ? ELEMENTS / n : 1,
        .a = allocate(n, sizeof(double)),
        .b = allocate(n, sizeof(double)),
        .to = allocate(n, sizeof(double)),
        .index = allocate(n, sizeof(uint32_t)),
        .a32 = allocate(n, sizeof(uint32_t)),
        .to32 = allocate(n, sizeof(uint32_t)),
        .keep = allocate(n, sizeof(uint8_t)),
    };
    fill(&w);
    return w;
}
//<

void workload_free(struct workload *workload)
{
    free(workload->a);
    free(workload->b);
    free(workload->to);
    free(workload->index);
    free(workload->a32);
    free(workload->to32);
    free(workload->keep);
    *workload = (struct workload){0};
}

//> Run a primitive
struct calls {
    const struct workload *workload;
    const struct primitives *primitives;
};

static void run_once(const struct workload *w,
                     const struct primitives *p)
{
    switch (w->work) {
    case GATHER_IN_ORDER:
    case GATHER_AT_RANDOM:
        p->gather(w->to, w->a, w->index, w->n);
        break;
    case GATHER32_IN_ORDER:
    case GATHER32_AT_RANDOM:
        p->gather32(w->to32, w->a32, w->index, w->n);
        break;
    case SCATTER_IN_ORDER:
    case SCATTER_AT_RANDOM:
        p->scatter(w->to, w->a, w->index, w->n);
        break;
    case SCAN:
        p->scan(w->to32, w->a32, w->n, 0);
        break;
    case PACK:
        p->pack(w->to32, w->a32, w->keep, w->n);
        break;
    default:
        p->add(w->to, w->a, w->b, w->n);
    }
}

static void run_rounds(void *context)
{
    const struct calls *run = context;
    for (int round = 0; round < run->workload->rounds; round++)
        run_once(run->workload, run->primitives);
}
//<

//> Time a primitive by element
void workload_price(const struct workload *workload, int trials,
                    const struct primitives *const *tables, int count,
                    struct summary *prices)
{
    struct calls runs[ISA_COUNT];
    struct trial turns[ISA_COUNT];
    for (int k = 0; k < count; k++) {
        runs[k] = (struct calls){workload, tables[k]};
        turns[k] =
            (struct trial){.work = run_rounds, .context = &runs[k]};
    }
    time_in_turn(trials, turns, count);
    double elements = (double)workload->n * workload->rounds;
    for (int k = 0; k < count; k++) {
        struct summary s = turns[k].summary;
        prices[k] = (struct summary){s.min / elements, s.q1 / elements,
                                     s.median / elements,
                                     s.q3 / elements, s.max / elements};
    }
}
//<
//<
