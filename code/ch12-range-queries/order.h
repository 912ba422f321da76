//> Declare orders
// References to numbers, from the lowest number on. They are sorted
// once, and repaired when the numbers have moved.
#pragma once
#include "ch12-range-queries/radix_sort.h"

// Makes order[0 .. n-1] the indices of x[0 .. n-1] in the order of
// these numbers; equal ones from the lowest index on. Linear in n. The
// room is for 2 n records.
void sort_order(const double *x, uint32_t *order, uint32_t n,
                struct radix_record *room);

// The numbers have moved: puts the references in order again, by
// insertion where that takes few shifts, and else anew. Says how many
// shifts there were. It gives up after MAX_SHIFTS for each number, on
// average.
enum { MAX_SHIFTS = 16 };
uint64_t repair_order(const double *x, uint32_t *order, uint32_t n,
                      struct radix_record *room);
//<
