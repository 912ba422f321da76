// All nearest neighbors of the same points by the programs of this book
// and by four libraries, one thread and all; the points as they come,
// and in an order that suits every search. For 1000, 10000, ... LARGEST
// points; few points get three times the TRIALS, and programs that
// would take more than SECONDS get fewer.
//     compare [LARGEST [TRIALS [SECONDS]]]
#include "common/experiment.h"
#include "peers/contest.h"
#include "peers/results.h"
#include "peers/strips.h"
#include <unistd.h>

#ifndef PEER_FLAGS
#define PEER_FLAGS "unknown"
#endif

enum { FEWEST = 1000, FEW = 100000, LEAVES_UP_TO = 1000000 };

// A point that takes ten times what is usual is not worth the wait.
static const double limit = 25000;

static const char *const ours[] = {"row-spans", "cells-threads",
                                   "vector-spiral", "spiral"};
static const struct peer *const peers[] = {&peer_nanoflann, &peer_cgal,
                                           &peer_ann, &peer_flann};
static const char *const kinds[] = {"uniform", "clustered", "kuzmin"};
static const char *const orders[] = {"unordered", "ordered"};
enum {
    OURS = COUNT_OF(ours),
    PEERS = COUNT_OF(peers),
    PROGRAMS = OURS + PEERS,
    KINDS = COUNT_OF(kinds),
    ORDERS = COUNT_OF(orders)
};

// A program and what is known of it from fewer points.
struct contender {
    struct program program;
    struct history history[KINDS];
    int leaf; // chosen on uniform points
};

static void list(struct contender all[PROGRAMS])
{
    for (int k = 0; k < OURS; k++)
        all[k].program = (struct program){
            ours[k], find_algorithm(ours[k])->run, NULL};
    for (int k = 0; k < PEERS; k++)
        all[OURS + k].program =
            (struct program){peers[k]->name, NULL, peers[k]};
}

static void print_head(const struct experiment *experiment)
{
    printf("# libraries:");
    for (int k = 0; k < PEERS; k++)
        printf("%s %s %s", k ? "," : "", peers[k]->name,
               peers[k]->version);
    printf("\n# flags of the libraries: %s\n", PEER_FLAGS);
    columns(experiment, result_columns);
}

static void show_progress(const struct entry *entry)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[K%u points, %s, %s: %s\r", entry->n,
                entry->kind, entry->order, entry->program);
}

static void compete_on(struct instance *instance, int kind, int order,
                       const struct rules *rules,
                       struct contender contenders[PROGRAMS])
{
    const uint32_t n = instance->points.n;
    struct answers *answers = new_answers(n, NEAREST);
    for (int k = 0; k < PROGRAMS; k++) {
        struct contender *c = &contenders[k];
        struct entry entry = {c->program.name, kinds[kind],
                              orders[order], n, 0};
        show_progress(&entry);
        if (c->program.peer && kind == 0 && n <= LEAVES_UP_TO)
            c->leaf = best_leaf(c->program.peer, instance, answers);
        entry.leaf = c->leaf;
        struct result result =
            compete(&c->program, c->leaf, rules, instance, answers,
                    &c->history[kind]);
        print_result(&entry, &result);
    }
    forget();
}

static void compete_for(uint32_t n, const struct rules *rules,
                        struct contender contenders[ORDERS][PROGRAMS])
{
    for (int kind = 0; kind < KINDS; kind++) {
        struct points unordered =
            generate(find_distribution(kinds[kind]), n, 1);
        struct points points[ORDERS] = {unordered,
                                        points_in_strips(unordered)};
        for (int order = 0; order < ORDERS; order++) {
            struct instance instance = instance_of(points[order]);
            compete_on(&instance, kind, order, rules,
                       contenders[order]);
            instance_free(&instance);
        }
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t largest = parameter(&e, "LARGEST", 10000, FEWEST, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MOST_TRIALS / 3);
    double seconds = parameter(&e, "SECONDS", 2, 1, MANY);
    static struct contender contenders[ORDERS][PROGRAMS];
    for (int order = 0; order < ORDERS; order++)
        list(contenders[order]);
    print_head(&e);
    for (uint64_t n = FEWEST; n <= largest; n *= 10) {
        struct rules rules = {.limit = limit,
                              .patience = seconds * 1e9,
                              .trials = n <= FEW ? 3 * trials : trials,
                              .threads = omp_get_num_procs()};
        compete_for(n, &rules, contenders);
    }
}
