// One loop, compiled three times: what differs is how much the
// compiler knows about the distance. Distances only, no indices.
#pragma once
#include "ch02-all-pairs/pair.h"

// A function the compiler does not see; a test in the loop; a copy of
// the loop for each geometry.
rows_function pointer_rows, flag_rows, copies_rows;

// The same with sixteen queries side by side; begin and end must be
// multiples of 16. Each is its own candidate, too: the nearest distance
// is 0.
rows_function pointer_lanes_rows, flag_lanes_rows, copies_lanes_rows;
