// Price the primitives, length by length.
// Nanoseconds an element of each primitive against its working set, in
// portable C and with the chosen instruction set.
//     lengths [TRIALS [LARGEST]]
#include "ch06-pack-scan/experiments/caches.h"
#include "ch06-pack-scan/experiments/workload.h"

// Price every primitive at one length.
static void print_prices(size_t bytes, int trials)
{
    const struct caches caches = caches_of_machine();
    const struct primitives *both[] = {primitives(PORTABLE),
                                       primitives(isa_chosen())};
    struct summary ns[2][WORKS];
    price_tables(trials, bytes, both, 2, ns);
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
    columns(&e, "primitive bytes l1 l2 l3 portable_ns:3 vector_ns:3");
    for (size_t bytes = 1 << 12; bytes <= largest; bytes *= 2)
        print_prices(bytes, trials);
}
