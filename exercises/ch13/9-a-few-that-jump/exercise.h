// Exercise: a few that jump
#pragma once
#include <stdbool.h>
#include <stdint.h>

// Whether box a begins before box b. Given; it counts. No two begin at
// the same place.
bool begins_before(uint32_t a, uint32_t b);

// Puts the n boxes of the order into the order in which they begin now.
// The room is for n boxes.
void repair(uint32_t n, uint32_t *order, uint32_t *room);
