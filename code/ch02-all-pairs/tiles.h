//> Declare the tiles
// All pairs, as fast as one core will in plain C: eight queries at a
// time, each in a vector lane of its own; every candidate is loaded
// once for all of them (register tiling, as in a matrix product). n
// (n-1) distances, at most 512 n more to find the indices, and less
// than 8 n for the spare lanes of a last tile that is not full; no
// memory of its own; threads share out the tiles.
#pragma once
#include "ch02-all-pairs/pair.h"

// Nearest and furthest, both geometries.
search_function tiles;

// The same on one thread, for some of the rows; begin must be a
// multiple of 8. The second leaves all subtractions to the adders.
rows_function tiles_rows, queries_rows;

// The same in blocks of another size, a multiple of 8.
void tiles_blocked_rows(const struct question *question,
                        struct answers *answers, uint32_t begin,
                        uint32_t end, uint32_t block);
//<
