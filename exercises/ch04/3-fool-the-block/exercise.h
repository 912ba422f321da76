// Exercise: fool the block
#pragma once
#include "common/points.h"

enum { COLUMNS = 30, ROWS = 20 };

// Sets x in [0, COLUMNS) and y in [0, ROWS) of all points so that the
// block misses the nearest neighbor. There are 4 points or 100.
void fool_the_block(struct points points);
