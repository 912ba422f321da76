//> Compare with other libraries
// All nearest neighbors of the same points by the programs of this book
// and by four libraries, one thread and all; the points as they come,
// and in an order that suits every search.
//
//     compare [LARGEST [TRIALS [SECONDS]]]
//
// for 1,000, 10,000, ... LARGEST points, with so many trials, three
// times as many for few points, and fewer where a program would be at
// it for more than so many SECONDS.
#include "algorithms.h"
#include "common/experiment.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/report.h"
#include "peers/contest.h"
#include "peers/results.h"
#include "peers/strips.h"
#include <omp.h>
#include <stdio.h>
#include <unistd.h>

#ifndef PEER_FLAGS
#define PEER_FLAGS "unknown"
#endif

enum { FEWEST = 1000, FEW = 100000, LEAVES_UP_TO = 1000000 };

// Nobody waits for a point that takes ten times what is usual.
static const double limit = 25000;

//> List the programs
static const char *const ours[] = {"row-spans", "cells-threads",
                                   "vector-spiral", "spiral"};
static const struct peer *const peers[] = {&peer_nanoflann, &peer_cgal,
                                           &peer_ann, &peer_flann};
enum {
    OURS = sizeof ours / sizeof *ours,
    PEERS = sizeof peers / sizeof *peers,
    PROGRAMS = OURS + PEERS
};

static void list(struct program programs[PROGRAMS])
{
    for (int k = 0; k < OURS; k++)
        programs[k] = (struct program){
            ours[k], find_algorithm(ours[k])->run, NULL};
    for (int k = 0; k < PEERS; k++)
        programs[OURS + k] =
            (struct program){peers[k]->name, NULL, peers[k]};
}
//<

static void print_head(void)
{
    report_provenance(stdout);
    printf("# libraries:");
    for (int k = 0; k < PEERS; k++)
        printf("%s %s %s", k ? "," : "", peers[k]->name,
               peers[k]->version);
    printf("\n# flags of the libraries: %s\n", PEER_FLAGS);
    print_columns(stdout);
}

//> Say what is going on
static void tell(uint32_t n, const char *kind, const char *order,
                 const char *name)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[K%u points, %s, %s: %s\r", n, kind,
                order, name);
}
//<

static const char *const kinds[] = {"uniform", "clustered", "kuzmin"};
enum { KINDS = sizeof kinds / sizeof *kinds, ORDERS = 2 };
static const char *const orders[ORDERS] = {"coming", "ordered"};

// What is remembered of a program from ground to ground.
struct memory {
    struct history history[KINDS];
    int leaf; // chosen on uniform points
};

//> Let all compete on one ground
static void compete_on(struct ground *ground, int kind,
                       const char *order, const struct rules *rules,
                       const struct program programs[PROGRAMS],
                       struct memory memory[PROGRAMS])
{
    const uint32_t n = ground->points.n;
    struct answers answers = answers_for(n, NEAREST);
    for (int k = 0; k < PROGRAMS; k++) {
        const struct program *program = &programs[k];
        struct memory *its = &memory[k];
        tell(n, kinds[kind], order, program->name);
        if (program->peer && kind == 0 && n <= LEAVES_UP_TO)
            its->leaf = best_leaf(program->peer, ground, &answers);
        struct result result =
            compete(program, its->leaf, rules, ground, &answers,
                    &its->history[kind]);
        print_result(stdout, program->name, kinds[kind], n, order,
                     its->leaf, &result);
    }
    answers_free(&answers);
}
//<

//> Let all compete for so many points
static void compete_for(uint32_t n, const struct rules *rules,
                        const struct program programs[PROGRAMS],
                        struct memory memory[ORDERS][PROGRAMS])
{
    for (int kind = 0; kind < KINDS; kind++) {
        struct points coming =
            generate(find_distribution(kinds[kind]), n, 1);
        struct points points[ORDERS] = {coming,
                                        points_in_strips(coming)};
        for (int order = 0; order < ORDERS; order++) {
            struct ground ground = ground_over(points[order]);
            compete_on(&ground, kind, orders[order], rules, programs,
                       memory[order]);
            ground_free(&ground);
        }
    }
}
//<

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t largest = parameter(&e, "LARGEST", 10000, FEWEST, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MOST_TRIALS / 3);
    double seconds = parameter(&e, "SECONDS", 2, 1, MANY);
    static struct program programs[PROGRAMS];
    static struct memory memory[ORDERS][PROGRAMS];
    list(programs);
    print_head();
    for (uint64_t n = FEWEST; n <= largest; n *= 10) {
        struct rules rules = {.limit = limit,
                              .patience = seconds * 1e9,
                              .trials = n <= FEW ? 3 * trials : trials,
                              .threads = omp_get_num_procs()};
        compete_for(n, &rules, programs, memory);
    }
    return 0;
}
//<
