// Chapter 5's conflict detection, with emulated instructions.
#include "common/isa.h"
#define isa_chosen() AVX512
#define conflict_count emulated_conflict_count
#define conflict_place emulated_conflict_place
#define cells_sort_conflict emulated_cells_sort_conflict
#include "ch05-collisions/conflict.c"
