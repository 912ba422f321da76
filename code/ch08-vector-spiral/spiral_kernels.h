//> Declare the kernels of the spiral
// What all tasks of a strip do at a cell, and at a point of it: the two
// inner loops (Su, figures 7 and 8). There are several versions, and
// all of them change a strip in the same way, to the last bit.
#pragma once
#include "ch08-vector-spiral/strip.h"

//> Name what the kernels do
struct spiral_kernels {
    enum isa isa; // also of the primitives between the kernels

    // All tasks of the list take the same step, dx columns and dy rows
    // from the cells of their queries. Those whose bounds allow it and
    // that find points there become the visits of the strip.
    void (*enter_cells)(const struct map *map, struct strip *strip,
                        const struct tasks *tasks, int32_t dx,
                        int32_t dy);

    // Every visit compares its next point; those that have compared
    // the last one of their cell are packed away.
    void (*compare_points)(const struct map *map, struct strip *strip);
};
//<

// The fused kernels: each of the two inner loops in one pass; what was
// an array between two primitives is a register. In plain C, and eight
// tasks at a time in AVX2 and AVX-512, which are for x86-64 only.
extern const struct spiral_kernels portable_spiral, avx2_spiral,
    avx512_spiral;

// Those for an instruction set, which must be present.
const struct spiral_kernels *spiral_kernels(enum isa isa);

//> Step along an axis in a known geometry
// For a step within the search bounds; only with wraparound can it lead
// past an end.
INLINED int32_t cell_after(const enum geometry geometry,
                           const struct axis *axis, int32_t cell,
                           int32_t steps)
{
    int32_t m = axis->count, to = cell + steps;
    if (geometry == STANDARD)
        return to;
    return to < 0 ? to + m : to < m ? to : to - m;
}
//<
//<
