//> Declare the versions to compare
// The spiral search and its vectorizations, with the sort: as
// search_functions, so that they can be timed like those of the table.
#pragma once
#include "common/question.h"

// Chapter 7's, with the points asking in the order of the cells.
search_function spiral_in_order;

// The march by primitives and with fused loops, with the chosen
// instruction set and in plain C; strips as long as the table has them.
search_function march_primitives, march_primitives_plain;
search_function march_fused_plain;
//<
