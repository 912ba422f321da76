// All nearest neighbors of the same points by the programs of this book
// and by four libraries, one thread and all; the points as they come,
// and in an order that suits every search. For 1000, 10000, ... LARGEST
// points; few points get three times the TRIALS, and programs that
// would take more than SECONDS get fewer.
//     compare [LARGEST [TRIALS [SECONDS]]]
#include "peers/contenders.h"
#include "peers/strips.h"

enum { FEWEST = 1000, FEW = 100000 };

static const char *const ours[] = {"row-spans", "cells-threads",
                                   "vector-spiral", "spiral"};
static const char *const kinds[] = {"uniform", "clustered", "kuzmin"};
static const char *const orders[] = {"unordered", "ordered"};
enum { KINDS = COUNT_OF(kinds), ORDERS = COUNT_OF(orders) };

static void compete_for(uint32_t n, const struct rules *rules,
                        struct contenders contenders[ORDERS])
{
    for (int kind = 0; kind < KINDS; kind++) {
        struct points unordered =
            generate(find_distribution(kinds[kind]), n, 1);
        struct points points[ORDERS] = {unordered,
                                        points_in_strips(unordered)};
        for (int order = 0; order < ORDERS; order++) {
            const struct workload workload = {kinds[kind],
                                              orders[order], kind};
            struct instance instance = instance_of(points[order]);
            compete_on(&workload, rules, &instance, &contenders[order]);
            instance_free(&instance);
        }
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t largest = parameter(&e, "LARGEST", 10000, FEWEST, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS / 3);
    double seconds = parameter(&e, "SECONDS", 2, 1, MANY);
    static struct contenders contenders[ORDERS];
    for (int order = 0; order < ORDERS; order++)
        contenders[order] = contenders_of(ours, COUNT_OF(ours));
    print_head(&e);
    for (uint64_t n = FEWEST; n <= largest; n *= 10) {
        struct rules rules = {.limit = MAX_NS_A_POINT,
                              .patience = seconds * 1e9,
                              .trials = n <= FEW ? 3 * trials : trials,
                              .threads = omp_get_num_procs()};
        compete_for(n, &rules, contenders);
    }
}
