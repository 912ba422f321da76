//> Declare the kernels for the furthest
// With wraparound the furthest point is near, as the sum of the axes'
// separations goes. So it is among the candidates that chapter 9 stages
// for the nearest, and a kernel of the batch search finds it there.
#pragma once
#include "ch09-row-spans/batch.h"
#include "ch10-furthest/far_batch.h"
#include "common/isa.h"

// One for each instruction set; only with wraparound. What it certifies
// is the furthest of all points, by its furthest image.
batch_kernel portable_furthest, avx2_furthest, avx512_furthest;

// That of the instruction set that is chosen.
batch_kernel *furthest_kernel(void);

// How far a staging buffer may reach for these kernels to be any good:
// no separation in it must be more than half a period, and no loss more
// than a float can hold.
static inline double furthest_max_reach(struct space space)
{
    return MAX(space.width, space.height) <= 0x1p50
               ? MIN(space.width, space.height) / 5
               : 0;
}

//> Bound the distance to all that is outside of a block
// Of a point as far away as the margin, which is at most half a period,
// the image on the longer way.
static inline double furthest_outside2(const struct grid *grid,
                                       const struct block *block,
                                       struct space space, double x,
                                       double y)
{
    double w = space.width, h = space.height;
    double across = w - range_margin(&grid->x, &block->x, x);
    double up = h - range_margin(&grid->y, &block->y, y);
    return MAX(across * across + h * h, w * w + up * up) *
           ROUNDING_GUARD;
}
//<
//<
