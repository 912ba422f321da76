// Time packs against the share that is kept.
// With a branch for every element, without one, and by instruction set:
// nanoseconds an element.
//
//     branches [LENGTH [TRIALS]]
#include "ch06-pack-scan/primitives.h"
#include "common/allocate.h"
#include "common/experiment.h"
#include "common/random.h"
#include <stdlib.h>

//> Pack with a branch
static uint32_t pack_branching(uint32_t *to, const uint32_t *from,
                               const uint8_t *keep, uint32_t n)
{
    uint32_t k = 0;
    for (uint32_t i = 0; i < n; i++)
        if (keep[i])
            to[k++] = from[i];
    return k;
}
//<

struct packing {
    uint32_t (*pack)(uint32_t *, const uint32_t *, const uint8_t *,
                     uint32_t);
    uint32_t *to, *from, n;
    uint8_t *keep;
};

static void run_packing(void *context)
{
    struct packing *p = context;
    p->pack(p->to, p->from, p->keep, p->n);
}

// Keep this share of the elements.
static void fill(struct packing *packing, int percent)
{
    struct random random = {percent + 1};
    for (uint32_t i = 0; i < packing->n; i++) {
        packing->from[i] = i;
        packing->keep[i] = random_uniform(&random) * 100 < percent;
    }
}

static void print_versions(int percent, const struct trial *versions,
                           int count, uint32_t n)
{
    row_of_times(versions, count, n, "kept_%d\t%d", percent, percent);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "LENGTH", 1 << 17, 1, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct packing packing = {NULL, allocate(n, sizeof(uint32_t)),
                              allocate(n, sizeof(uint32_t)), n,
                              allocate(n, sizeof(uint8_t))};
    struct packing branching = packing, portable = packing,
                   chosen = packing;
    branching.pack = pack_branching;
    portable.pack = primitives(PORTABLE)->pack;
    chosen.pack = primitives(isa_chosen())->pack;
    struct trial versions[] = {
        {.work = run_packing, .context = &branching},
        {.work = run_packing, .context = &portable},
        {.work = run_packing, .context = &chosen}};
    enum { VERSIONS = sizeof versions / sizeof *versions };

    columns(&e, "name percent branch_ns:3 portable_ns:3 vector_ns:3");
    for (int percent = 0; percent <= 100; percent += 5) {
        fill(&packing, percent);
        time_in_turn(trials, versions, VERSIONS);
        print_versions(percent, versions, VERSIONS, n);
    }
    free(packing.to);
    free(packing.from);
    free(packing.keep);
    return 0;
}
