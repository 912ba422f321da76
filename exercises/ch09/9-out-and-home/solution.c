// Both ways take two passes. Out: to buckets of cells, which are so few
// that a line of each is in the cache, then in each bucket to the
// cells. Home: to buckets of indices, whose places are known without a
// count.
#include "exercise.h"
#include <string.h>

//- solution
enum { BUCKET = 768, BUCKETS = RECORDS_MOST / BUCKET + 1 };

// count[k] becomes where k begins, if the first begins at a place.
static void scan(uint32_t many, uint32_t *count, uint32_t place)
{
    for (uint32_t k = 0; k < many; k++) {
        const uint32_t here = count[k];
        count[k] = place;
        place += here;
    }
}

static void sort_bucket(uint32_t begin, uint32_t end)
{
    uint32_t next[BUCKET] = {0};
    for (uint32_t s = begin; s < end; s++)
        next[get(ROOM, s).cell % BUCKET]++;
    scan(BUCKET, next, begin);
    for (uint32_t s = begin; s < end; s++) {
        const struct record record = get(ROOM, s);
        set(SORTED, next[record.cell % BUCKET]++, record);
    }
}

//- starter
//- end
void go_out(uint32_t n)
{
    //- solution
    uint32_t next[BUCKETS] = {0};
    for (uint32_t i = 0; i < n; i++)
        next[get(INPUT, i).cell / BUCKET]++;
    scan(BUCKETS, next, 0);
    for (uint32_t i = 0; i < n; i++) {
        const struct record record = get(INPUT, i);
        set(ROOM, next[record.cell / BUCKET]++, record);
    }
    for (uint32_t b = 0; b < BUCKETS; b++)
        sort_bucket(b > 0 ? next[b - 1] : 0, next[b]);
    //- starter
    // // Your turn: so far it is a copy.
    // for (uint32_t i = 0; i < n; i++)
    //     set(SORTED, i, get(INPUT, i));
    //- end
}

void go_home(uint32_t n)
{
    //- solution
    uint32_t next[BUCKETS];
    for (uint32_t b = 0; b < BUCKETS; b++)
        next[b] = b * BUCKET; // for each index there is a result
    for (uint32_t s = 0; s < n; s++) {
        const struct record record = get(SORTED, s);
        set(ROOM, next[record.index / BUCKET]++, record);
    }
    for (uint32_t s = 0; s < n; s++) {
        const struct record record = get(ROOM, s);
        set(OUTPUT, record.index, record);
    }
    //- starter
    // // Your turn: so far it is a copy.
    // for (uint32_t s = 0; s < n; s++)
    //     set(OUTPUT, s, get(SORTED, s));
    //- end
}
