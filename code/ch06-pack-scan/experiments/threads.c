// Time scan and pack over threads.
// On one thread; over two, in one block each; over two, in blocks that
// fit into the second cache. Nanoseconds an element.
//     threads [TRIALS [LONGEST]]
#include "ch06-pack-scan/blocked.h"
#include "common/experiment.h"

enum { BLOCK = 1 << 15, THREADS = 2 };

struct calls {
    const struct primitives *p;
    uint32_t *to, *from, n, block;
    uint8_t *keep;
    int threads, rounds;
};

// Scan or pack, alone or together.
static void run_scan(void *context)
{
    const struct calls *r = context;
    const struct rounds rounds = {r->p, r->block, r->threads};
    for (int round = 0; round < r->rounds; round++)
        if (r->threads > 1)
            scan_blocked(&rounds, r->to, r->from, r->n, 0);
        else
            r->p->scan(r->to, r->from, r->n, 0);
}

static void run_pack(void *context)
{
    const struct calls *r = context;
    const struct rounds rounds = {r->p, r->block, r->threads};
    for (int round = 0; round < r->rounds; round++)
        if (r->threads > 1)
            pack_blocked(&rounds, r->to, r->from, r->keep, r->n);
        else
            r->p->pack(r->to, r->from, r->keep, r->n);
}

static void print_times(const char *name, void (*work)(void *),
                        struct calls alone, int trials)
{
    struct calls whole = alone, blocks;
    whole.threads = THREADS;
    whole.block = alone.n / whole.threads + 1;
    blocks = whole;
    blocks.block = BLOCK;
    struct trial turns[] = {
        {work, &alone}, {work, &whole}, {work, &blocks}};
    time_in_turn(trials, turns, 3);
    row_of_times(turns, 3, (double)alone.n * alone.rounds,
                 "%s_%u\t%u\t%d", name, alone.n, alone.n,
                 whole.threads);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    uint32_t longest = parameter(&e, "LONGEST", 1 << 22, 1 << 12, MANY);
    struct calls run = {
        .p = primitives(isa_chosen()),
        .to = take(longest, sizeof(uint32_t)),
        .from = take(longest, sizeof(uint32_t)),
        .keep = take(longest, sizeof(uint8_t)),
        .threads = 1,
    };
    struct random random = {1};
    for (uint32_t i = 0; i < longest; i++) {
        run.to[i] = run.from[i] = i % 4;
        run.keep[i] = random_bits(&random) & 1;
    }
    print_header(&e, "name n threads one_ns:3 halves_ns:3 blocks_ns:3");
    for (uint32_t n = 1 << 12; n <= longest; n *= 4) {
        run.n = n;
        run.rounds = n < 1 << 20 ? (1 << 20) / n : 1;
        print_times("scan", run_scan, run, trials);
        print_times("pack", run_pack, run, trials);
    }
}
