// Exercise: a median for little
#pragma once
#include <stdbool.h>
#include <stdint.h>

// Whether number a is less than number b. Given; it counts. No two are
// equal.
bool is_less(uint32_t a, uint32_t b);

// Which of the numbers 0 to n - 1, n >= 1, has this rank: just rank of
// them are less. The room is for 2 n.
uint32_t number_of_rank(uint32_t n, uint32_t rank, uint32_t *room);
