// Exercise: longest first
#pragma once
#include <stdint.h>

// Given: every lane does a round of its task. Costs 1 for each lane.
void make_round(uint32_t lanes, const uint32_t *task);

// Does length[i] rounds of every task i, 0 to n-1; none is longer than
// longest. order and places belong to you: room for n tasks, and for
// longest + 1 places.
void work_off(uint32_t n, const uint32_t *length, uint32_t longest,
              uint32_t *order, uint32_t *places);
