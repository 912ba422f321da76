//> Declare the radix sort
// Records with keys of 64 bits, sorted by Hollerith's way of 1887: one
// digit after the other, the last digit first, each by count, scan and
// place. Linear in n.
#pragma once
#include <stdint.h>

//> Hold a record to be sorted
struct radix_record {
    uint64_t key;
    uint32_t point;
};
//<

// Bits whose order, as whole numbers, is that of the numbers; both
// zeros give the same.
uint64_t radix_key(double number);

// Sorts n records by the lowest bits of their keys, so many of them;
// equal ones stay in their order. The room is for n more.
void radix_sort(struct radix_record *record, uint32_t n, int bits,
                struct radix_record *room);
//<
