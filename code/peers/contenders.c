// Each chooses the size of its leaves on the first points that it gets,
// and keeps a history, by which its next time is expected.
#include "peers/contenders.h"
#include "peers/results.h"
#include <assert.h>
#include <unistd.h>

#ifndef PEER_FLAGS
#define PEER_FLAGS "unknown"
#endif

enum { LEAVES_UP_TO = 1000000 };

static const struct peer *const peers[] = {&peer_nanoflann, &peer_cgal,
                                           &peer_ann, &peer_flann};
enum { PEERS = COUNT_OF(peers) };

struct contenders contenders_of(const char *const *ours, int count)
{
    struct contenders all = {.count = count + PEERS};
    assert(all.count <= MOST_CONTENDERS && "room for all");
    for (int k = 0; k < count; k++)
        all.contender[k].program = (struct program){
            ours[k], find_algorithm(ours[k])->run, NULL};
    for (int k = 0; k < PEERS; k++)
        all.contender[count + k].program =
            (struct program){peers[k]->name, NULL, peers[k]};
    return all;
}

void print_head(const struct experiment *experiment)
{
    printf("# libraries:");
    for (int k = 0; k < PEERS; k++)
        printf("%s %s %s", k ? "," : "", peers[k]->name,
               peers[k]->version);
    printf("\n# flags of the libraries: %s\n", PEER_FLAGS);
    print_header(experiment, result_columns);
}

static void show_progress(const struct entry *entry)
{
    if (isatty(STDERR_FILENO))
        fprintf(stderr, "\r\033[K%u points, %s, %s: %s\r", entry->n,
                entry->kind, entry->order, entry->program);
}

void compete_on(const struct workload *workload,
                const struct rules *rules, struct instance *instance,
                struct contenders *contenders)
{
    const uint32_t n = instance->points.n;
    const int kind = workload->number;
    struct answers *answers = new_answers(n, NEAREST);
    assert(kind < MOST_KINDS && "room for the history");
    for (int k = 0; k < contenders->count; k++) {
        struct contender *c = &contenders->contender[k];
        struct entry entry = {c->program.name, workload->kind,
                              workload->order, n, 0};
        show_progress(&entry);
        if (c->program.peer && kind == 0 && n <= LEAVES_UP_TO)
            c->leaf_size =
                best_leaf_size(c->program.peer, instance, answers);
        entry.leaf_size = c->leaf_size;
        const struct result result =
            compete(&c->program, c->leaf_size, rules, instance, answers,
                    &c->history[kind]);
        print_result(&entry, &result);
    }
    forget();
}
