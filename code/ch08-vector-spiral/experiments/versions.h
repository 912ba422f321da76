// The spiral search and its vectorizations, with the sort: as
// search_functions, so that they can be timed like those of the table.
#pragma once
#include "common/question.h"

// Chapter 7's, with the queries in the order of the cells.
search_function spiral_in_order;

// Advancing in step by primitives and with fused kernels, with the
// chosen instruction set and in plain C; strips as long as the table
// has them.
search_function spiral_primitives, spiral_primitives_plain;
search_function spiral_fused_plain;
