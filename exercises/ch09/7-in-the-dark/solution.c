// One by one, a key goes down the list of those that are kept, and in
// each place the smaller one stays. In groups of k, if k is a power of
// two: sort the group by a network (Batcher 1968), take the smaller one
// of each pair from both ends, which leaves the k smallest, and put
// these in order.
#include "exercise.h"

//- solution
static void exchange(const struct key **a, const struct key **b)
{
    const struct key *greater = most(*a, *b);
    *a = least(*a, *b);
    *b = greater;
}

static void insert(const struct key *key, uint32_t k,
                   const struct key **kept)
{
    for (uint32_t i = 0; i + 1 < k; i++)
        exchange(&kept[i], &key);
    kept[k - 1] = least(kept[k - 1], key);
}

enum { GROUP_MOST = 64 };

static int fits_group(uint32_t k)
{
    return k >= 4 && k <= GROUP_MOST && (k & (k - 1)) == 0;
}

// Batcher's merge sort: pairs of sorted halves become sorted.
static void sort(uint32_t k, const struct key **group)
{
    for (uint32_t p = 1; p < k; p *= 2)
        for (uint32_t q = p; q >= 1; q /= 2)
            for (uint32_t j = q % p; j + q < k; j += 2 * q)
                for (uint32_t i = j; i < j + q && i + q < k; i++)
                    if (i / (2 * p) == (i + q) / (2 * p))
                        exchange(&group[i], &group[i + q]);
}

static void merge(uint32_t k, const struct key **group,
                  const struct key **kept)
{
    for (uint32_t i = 0; i < k; i++)
        kept[i] = least(kept[i], group[k - 1 - i]);
    for (uint32_t q = k / 2; q >= 1; q /= 2)
        for (uint32_t i = 0; i < k; i++)
            if ((i & q) == 0)
                exchange(&kept[i], &kept[i + q]);
}

//- starter
//- end
void keep_smallest(uint32_t n, const struct key *const *key, uint32_t k,
                   const struct key **kept)
{
    //- solution
    uint32_t next = 0;
    for (uint32_t i = 0; i < k; i++)
        kept[i] = nothing();
    for (; fits_group(k) && next + k <= n; next += k) {
        const struct key *group[GROUP_MOST];
        for (uint32_t i = 0; i < k; i++)
            group[i] = key[next + i];
        sort(k, group);
        merge(k, group, kept);
    }
    for (; next < n; next++)
        insert(key[next], k, kept);
    //- starter
    // // Your turn: so far only the smallest one is found.
    // for (uint32_t i = 0; i < k; i++)
    //     kept[i] = nothing();
    // for (uint32_t i = 0; i < n; i++)
    //     kept[0] = least(kept[0], key[i]);
    //- end
}
