// Time packs against the share that is kept.
// With a branch for every element, without one, and by instruction set:
// nanoseconds an element.
//     branches [LENGTH [TRIALS]]
#include "ch06-pack-scan/primitives.h"
#include "common/experiment.h"

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

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "LENGTH", 1 << 17, 1, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct packing branching = {
        pack_branching, take(n, sizeof(uint32_t)),
        take(n, sizeof(uint32_t)), n, take(n, sizeof(uint8_t))};
    struct packing portable = branching, chosen = branching;
    portable.pack = primitives(PORTABLE)->pack;
    chosen.pack = primitives(isa_chosen())->pack;
    struct trial versions[] = {{run_packing, &branching},
                               {run_packing, &portable},
                               {run_packing, &chosen}};
    print_header(&e,
                 "name percent branch_ns:3 portable_ns:3 vector_ns:3");
    for (int percent = 0; percent <= 100; percent += 5) {
        fill(&branching, percent); // which all three pack
        time_in_turn(trials, versions, 3);
        row_of_times(versions, 3, n, "kept_%d\t%d", percent, percent);
    }
}
