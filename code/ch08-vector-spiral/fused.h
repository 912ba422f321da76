//> Declare the fused loops
// The two inner loops in one pass each: what was an array between two
// primitives is a register. In plain C, AVX2 and AVX-512.
#pragma once
#include "ch08-vector-spiral/loops.h"

// For an instruction set that is present.
struct loops loops_fused(enum isa isa);

// Those of a vector version do the visits that do not fill a vector
// with these: from number i on, k of those before being kept. Each
// returns how many are kept then.
uint32_t enter_rest(const struct map *map, struct strip *strip,
                    const struct tasks *tasks, int32_t dx, int32_t dy,
                    uint32_t i, uint32_t k);
uint32_t look_rest(const struct map *map, struct strip *strip,
                   uint32_t i, uint32_t k);

extern const struct loops portable_loops;
//<
