//> Declare the triangle of tiles
// The triangular loop cut into tiles of 256 by 256 pairs. Inside a tile
// a thread works alone, on vectors; only the tile's results are offered
// to the bests that all threads share. n (n-1) / 2 distances and at
// most 512 n more to find the indices; 32 bytes a point, however many
// threads.
#pragma once
#include "common/question.h"

// Ties go to the lowest index.
search_function triangle_tiles;
//<
