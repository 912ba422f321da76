//> Sort by digits
// Digits of eleven bits: their counts fit in the first cache. A digit
// that is the same in all keys is passed over.
#include "ch12-range-queries/radix_sort.h"
#include "ch04-cell-sort/cells.h"
#include <stdbool.h>
#include <string.h>

enum { DIGIT_BITS = 11, DIGITS = 1 << DIGIT_BITS };

//> Make a key of a number
// A double is sign, exponent, fraction: as a whole number it grows with
// the number, if the sign is turned over, and for a negative one all
// bits are.
uint64_t radix_key(double number)
{
    uint64_t bits;
    number += 0.0; // -0 becomes 0
    memcpy(&bits, &number, sizeof bits);
    return bits >> 63 ? ~bits : bits | (uint64_t)1 << 63;
}
//<

//> Place the records by one digit
// False if they all have the same.
static bool place_by(const struct radix_record *from, uint32_t n,
                     int shift, struct radix_record *to)
{
    uint32_t next[DIGITS] = {0};
    for (uint32_t i = 0; i < n; i++)
        next[from[i].key >> shift & (DIGITS - 1)]++;
    if (next[from[0].key >> shift & (DIGITS - 1)] == n)
        return false;
    cells_scan(next, DIGITS, 0);
    for (uint32_t i = 0; i < n; i++)
        to[next[from[i].key >> shift & (DIGITS - 1)]++] = from[i];
    return true;
}
//<

void radix_sort(struct radix_record *record, uint32_t n, int bits,
                struct radix_record *room)
{
    struct radix_record *from = record, *to = room;
    for (int shift = 0; shift < bits; shift += DIGIT_BITS)
        if (place_by(from, n, shift, to)) {
            struct radix_record *swap = from;
            from = to;
            to = swap;
        }
    if (from != record)
        memcpy(record, from, n * sizeof *record);
}
//<
