// Price the primitives, length by length.
// Nanoseconds an element of each primitive against its working set, in
// portable C and with the chosen instruction set, in the best of a few
// passes.
//     lengths [TRIALS [LARGEST]]
#include "ch06-pack-scan/experiments/caches.h"
#include "ch06-pack-scan/experiments/workload.h"

enum { PASSES = 5, SIZES = 32 };

// Portable and chosen, for every primitive, length by length.
typedef struct summary prices[2][WORKS];

// A length takes a few milliseconds, in which the machine may be busy
// with something else. So all lengths are gone through several times,
// and each keeps its best pass.
static void keep_better(prices ns, prices of_pass)
{
    for (int k = 0; k < 2; k++)
        for (int work = 0; work < WORKS; work++)
            if (of_pass[k][work].median < ns[k][work].median)
                ns[k][work] = of_pass[k][work];
}

static void price_length(size_t bytes, int trials, bool first,
                         prices ns)
{
    const struct primitives *both[] = {primitives(PORTABLE),
                                       primitives(isa_chosen())};
    prices of_pass;
    price_tables(trials, bytes, both, 2, of_pass);
    if (first)
        memcpy(ns, of_pass, sizeof of_pass);
    keep_better(ns, of_pass);
}

static void print_prices(size_t bytes, prices ns)
{
    const struct caches caches = caches_of_machine();
    for (int work = 0; work < WORKS; work++) {
        row_begin("%s\t%zu\t%zu\t%zu\t%zu", work_names[work], bytes,
                  caches.l1, caches.l2, caches.l3);
        row_times(&ns[0][work], 1);
        row_times(&ns[1][work], 1);
        row_end();
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    size_t largest = parameter(&e, "LARGEST", 1 << 24, 1 << 12, MANY);
    static prices ns[SIZES];
    for (int pass = 0; pass < PASSES; pass++) {
        size_t bytes = 1 << 12;
        for (int k = 0; bytes <= largest; k++, bytes *= 2)
            price_length(bytes, trials, pass == 0, ns[k]);
    }
    print_header(&e,
                 "primitive bytes l1 l2 l3 portable_ns:3 vector_ns:3");
    size_t bytes = 1 << 12;
    for (int k = 0; bytes <= largest; k++, bytes *= 2)
        print_prices(bytes, ns[k]);
}
