//> Scan and pack over threads
// In every round each thread has one block. First all sum up their own
// block, then one thread scans the sums, then all do the work, each
// from its own sum: 2n steps instead of n, shared among the threads.
#include "ch06-pack-scan/blocked.h"
#include "common/allocate.h"
#include "common/chunk.h"
#include "common/min_max.h"
#include <assert.h>
#include <omp.h>
#include <stdlib.h>

//> Sum a block
static uint32_t sum_of(const uint32_t *from, uint32_t n)
{
    uint32_t sum = 0;
    for (uint32_t i = 0; i < n; i++)
        sum += from[i];
    return sum;
}
//<

//> Count the marks of a block
static uint32_t count_marks(const uint8_t *keep, uint32_t n)
{
    uint32_t sum = 0;
    for (uint32_t i = 0; i < n; i++)
        sum += keep[i];
    return sum;
}
//<

//> Declare what a team of threads shares
struct team {
    const struct primitives *p;
    int threads;
    uint32_t *sums;  // of each thread's block; then, what is before it
    uint32_t before; // the sum of everything before this round
};

static struct team team_for(const struct rounds *rounds, uint32_t sum)
{
    const int threads = rounds->threads;
    assert(rounds->block >= 1 && "rounds go on");
    return (struct team){rounds->primitives, threads,
                         allocate(threads, sizeof(uint32_t)), sum};
}
//<

//> Find a thread's block in a round
// Round by round, n numbers are cut into a block for each thread.
struct piece {
    uint32_t begin, n;
};

static struct piece piece_of(uint32_t n, int thread, int threads)
{
    uint32_t begin = chunk_begin(n, thread, threads);
    uint32_t end = chunk_begin(n, thread + 1, threads);
    return (struct piece){begin, end - begin};
}
//<

//> Find out what is before each block
// Every thread of the team calls it with the sum of its own block, and
// gets the sum of everything before that block.
static uint32_t sum_before(struct team *team, uint32_t mine)
{
    int me = omp_get_thread_num();
    team->sums[me] = mine;
#pragma omp barrier
#pragma omp single
    team->before = team->p->scan(team->sums, team->sums, team->threads,
                                 team->before);
    return team->sums[me];
}
//<

//> Scan in two passes
// Every thread of the team calls it.
static void scan_round(struct team *team, uint32_t *to,
                       const uint32_t *from, uint32_t n)
{
    struct piece my = piece_of(n, omp_get_thread_num(), team->threads);
    uint32_t mine = sum_of(from + my.begin, my.n);
    uint32_t before = sum_before(team, mine);
    team->p->scan(to + my.begin, from + my.begin, my.n, before);
}
//<

//> Scan in rounds
uint32_t scan_blocked(const struct rounds *rounds, uint32_t *to,
                      const uint32_t *from, uint32_t n, uint32_t sum)
{
    struct team team = team_for(rounds, sum);
#pragma omp parallel num_threads(rounds->threads)
    {
#pragma omp single
        team.threads = omp_get_num_threads(); // it may be fewer
        uint64_t all = (uint64_t)rounds->block * team.threads;
        for (uint64_t i = 0; i < n; i += all)
            scan_round(&team, to + i, from + i, MIN(n - i, all));
    }
    free(team.sums);
    return team.before;
}
//<

//> Pack a block into its place
// Right behind it is another thread's place, where nothing may spill:
// the last SPILL numbers that are kept are moved one by one.
static void pack_piece(const struct primitives *p, uint32_t *to,
                       const uint32_t *from, const uint8_t *keep,
                       uint32_t n)
{
    uint32_t last = n, room = 0;
    while (last > 0 && room < SPILL)
        room += keep[--last];
    uint32_t k = p->pack(to, from, keep, last);
    for (uint32_t i = last; i < n; i++)
        if (keep[i])
            to[k++] = from[i];
}
//<

//> Count every block, then pack it
static void pack_round(struct team *team, uint32_t *to,
                       const uint32_t *from, const uint8_t *keep,
                       uint32_t n)
{
    struct piece my = piece_of(n, omp_get_thread_num(), team->threads);
    uint32_t mine = count_marks(keep + my.begin, my.n);
    uint32_t before = sum_before(team, mine);
    pack_piece(team->p, to + before, from + my.begin, keep + my.begin,
               my.n);
}
//<

//> Pack in rounds
uint32_t pack_blocked(const struct rounds *rounds, uint32_t *to,
                      const uint32_t *from, const uint8_t *keep,
                      uint32_t n)
{
    struct team team = team_for(rounds, 0);
#pragma omp parallel num_threads(rounds->threads)
    {
#pragma omp single
        team.threads = omp_get_num_threads(); // it may be fewer
        uint64_t all = (uint64_t)rounds->block * team.threads;
        for (uint64_t i = 0; i < n; i += all)
            pack_round(&team, to, from + i, keep + i, MIN(n - i, all));
    }
    free(team.sums);
    return team.before;
}
//<
//<
