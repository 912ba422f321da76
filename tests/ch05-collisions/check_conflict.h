// The checks of conflict detection, for any pair of functions that
// count and place: every length from 0 to 300 in few and many cells,
// against plain loops. For tests/instructions, too.
#pragma once
#include "common/random.h"
#include "harness.h"
#include <string.h>

typedef void count_function(const uint32_t *cell_id, uint32_t n,
                            uint32_t *count);
typedef void place_function(const uint32_t *cell_id, uint32_t n,
                            uint32_t *next, uint32_t *point);

enum { MOST = 300, MOST_CELLS = 1000, UNTOUCHED = 0x5A5A5A5A };

// n points in m cells, whose counts begin with what is there already.
static inline bool check_counts(count_function *count_with, uint32_t n,
                                uint32_t m, struct random *random)
{
    uint32_t cell_id[MOST], right[MOST_CELLS + 1],
        found[MOST_CELLS + 1];
    for (uint32_t k = 0; k < m; k++)
        right[k] = random_bits(random) % 5;
    right[m] = UNTOUCHED;
    memcpy(found, right, sizeof found);
    for (uint32_t i = 0; i < n; i++) {
        cell_id[i] = random_bits(random) % m;
        right[cell_id[i]]++;
    }
    count_with(cell_id, n, found);
    for (uint32_t k = 0; k <= m; k++)
        if (!CHECK_INT(right[k], found[k],
                       "%u points in %u cells: count of cell %u", n, m,
                       k))
            return false;
    return true;
}

static inline bool check_places(place_function *place_with, uint32_t n,
                                uint32_t m, struct random *random)
{
    uint32_t cell_id[MOST], next[MOST_CELLS + 1] = {0},
                                              after[MOST_CELLS];
    uint32_t right[MOST + 1], found[MOST + 1];
    for (uint32_t i = 0; i < n; i++) {
        cell_id[i] = random_bits(random) % m;
        next[cell_id[i] + 1]++;
    }
    for (uint32_t k = 0; k < m; k++)
        next[k + 1] += next[k];
    memcpy(after, next, sizeof after);
    memset(found, UNTOUCHED & 0xff, sizeof found);
    memcpy(right, found, sizeof right);
    for (uint32_t i = 0; i < n; i++)
        right[after[cell_id[i]]++] = i;
    place_with(cell_id, n, next, found);
    for (uint32_t i = 0; i <= n; i++)
        if (!CHECK_INT(right[i], found[i],
                       "%u points in %u cells: place %u", n, m, i))
            return false;
    for (uint32_t k = 0; k < m; k++)
        if (!CHECK_INT(after[k], next[k],
                       "%u points in %u cells: end of cell %u", n, m,
                       k))
            return false;
    return true;
}

static inline void check_conflict(count_function *count_with,
                                  place_function *place_with)
{
    static const uint32_t cells[] = {1, 2, 3, 7, 8, 30, 100, 1000};
    for (uint32_t n = 0; n <= MOST; n++)
        for (int k = 0; k < 8; k++) {
            uint64_t seed = 8 * n + k;
            test_seed(seed);
            struct random random = {seed};
            if (!check_counts(count_with, n, cells[k], &random) ||
                !check_places(place_with, n, cells[k], &random))
                return;
        }
}
