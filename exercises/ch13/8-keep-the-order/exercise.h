// Exercise: keep the order
#pragma once
#include <stdbool.h>
#include <stdint.h>

struct end {
    uint32_t box;
    bool high; // or low
};

// The end at a place of the list. Given.
struct end end_at(uint32_t place);

// Whether the ends at this place and the next are in order: the lower
// one first; of equal ones, a low end before a high one, and the lower
// box before the higher. Given; it counts.
bool in_order(uint32_t place);

// Swaps the ends at this place and the next. Given; it counts.
void swap_ends(uint32_t place);

// Reports, given. Two boxes meet if the low end of each comes before
// the high end of the other in the list.
void meeting_begins(uint32_t i, uint32_t j);
void meeting_ends(uint32_t i, uint32_t j);

// Brings the list of so many ends into order, and reports for all boxes
// which begin to meet, and which no longer do.
void repair(uint32_t ends);
