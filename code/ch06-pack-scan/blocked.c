//> Scan and pack over threads
// See blocked.h.
#include "ch06-pack-scan/blocked.h"
#include "common/fail.h"
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

static uint32_t ones(const uint8_t *keep, uint32_t n)
{
    uint32_t sum = 0;
    for (uint32_t i = 0; i < n; i++)
        sum += keep[i];
    return sum;
}
//<

//> Find a thread's block in this round
struct piece {
    uint32_t begin, n;
};

static struct piece piece_of(uint64_t round, uint32_t block, int thread,
                             uint32_t n)
{
    uint64_t begin = round + (uint64_t)block * thread;
    begin = begin < n ? begin : n;
    uint64_t left = n - begin;
    return (struct piece){begin, left < block ? left : block};
}
//<

//> Scan every block twice
uint32_t scan_blocked(const struct primitives *p, uint32_t *to,
                      const uint32_t *from, uint32_t n, uint32_t sum,
                      uint32_t block, int threads)
{
    assert(block >= 1 && "rounds go on");
    uint32_t *sums = allocate(threads, sizeof *sums);
#pragma omp parallel num_threads(threads)
    {
        int me = omp_get_thread_num(), team = omp_get_num_threads();
        uint64_t all = (uint64_t)block * team;
        for (uint64_t round = 0; round < n; round += all) {
            struct piece piece = piece_of(round, block, me, n);
            sums[me] = sum_of(from + piece.begin, piece.n);
#pragma omp barrier
#pragma omp single
            sum = p->scan(sums, sums, team, sum);
            p->scan(to + piece.begin, from + piece.begin, piece.n,
                    sums[me]);
        }
    }
    free(sums);
    return sum;
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
uint32_t pack_blocked(const struct primitives *p, uint32_t *to,
                      const uint32_t *from, const uint8_t *keep,
                      uint32_t n, uint32_t block, int threads)
{
    assert(block >= 1 && "rounds go on");
    uint32_t *places = allocate(threads, sizeof *places), kept = 0;
#pragma omp parallel num_threads(threads)
    {
        int me = omp_get_thread_num(), team = omp_get_num_threads();
        uint64_t all = (uint64_t)block * team;
        for (uint64_t round = 0; round < n; round += all) {
            struct piece piece = piece_of(round, block, me, n);
            places[me] = ones(keep + piece.begin, piece.n);
#pragma omp barrier
#pragma omp single
            kept = p->scan(places, places, team, kept);
            pack_piece(p, to + places[me], from + piece.begin,
                       keep + piece.begin, piece.n);
        }
    }
    free(places);
    return kept;
}
//<
//<
