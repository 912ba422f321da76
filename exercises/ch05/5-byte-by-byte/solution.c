// Radix sort from the lowest byte to the highest. All histograms come
// from one reading, and a byte in which all agree is passed over.
#include "exercise.h"

//- solution
enum { BYTES = 4, VALUES = 256 };

static uint32_t byte(uint32_t key, int b)
{
    return key >> 8 * b & 0xff;
}

// Sums the counts to the places where each value begins.
static void scan(uint32_t *count)
{
    uint32_t sum = 0;
    for (int v = 0; v < VALUES; v++) {
        uint32_t here = count[v];
        count[v] = sum;
        sum += here;
    }
}

static void pass(int from, uint32_t n, int b, uint32_t *next)
{
    for (uint32_t i = 0; i < n; i++) {
        struct record record = get(from, i);
        put(1 - from, next[byte(record.key, b)]++, record);
    }
}

//- starter
//- end
int sort_records(uint32_t n)
{
    //- solution
    uint32_t count[BYTES][VALUES] = {0}, key = 0;
    for (uint32_t i = 0; i < n; i++) {
        key = get(0, i).key;
        for (int b = 0; b < BYTES; b++)
            count[b][byte(key, b)]++;
    }
    int from = 0;
    for (int b = 0; b < BYTES; b++)
        if (count[b][byte(key, b)] < n) {
            scan(count[b]);
            pass(from, n, b, count[b]);
            from = 1 - from;
        }
    return from;
    //- starter
    // // Your turn. So far the records only move to the other array.
    // for (uint32_t i = 0; i < n; i++)
    //     put(1, i, get(0, i));
    // return 1;
    //- end
}
