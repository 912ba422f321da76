//> Declare the escape times
// The example of chapter 6, the Mandelbrot set: how many steps z = z z
// + c, begun at 0, can be taken from a point c of the plane before |z|
// > 4. Every point has a lane of a vector, and all lanes take a step
// together. A point that has escaped keeps its lane busy until the
// vector is packed.
#pragma once
#include "ch06-pack-scan/primitives.h"
#include "common/points.h"

//> Declare the lanes
struct lanes {
    uint32_t n;                    // how many
    uint32_t *point;               // the number of each lane's point
    double *cx, *cy, *x, *y, *age; // c, z and the steps taken so far
    uint8_t *inside;               // 1 where |z| <= 4, else 0
    uint32_t *number, *kept;       // 0, 1, 2, ... and what a pack keeps
};
//<

// The points of a picture, row by row from the top: width by height
// small squares that cover -2.2 <= x <= 0.8, -1.125 <= y <= 1.125. To
// be released with points_free.
struct points picture(uint32_t width, uint32_t height);

// Room for at most max lanes, to be released with lanes_free.
struct lanes lanes_allocate(uint32_t max);
void lanes_free(struct lanes *lanes);

// Sets steps[0 .. c.n-1], at most limit, to the same numbers whether
// the lanes are packed after every so many steps or, for 0, never.
// There must be room for c.n lanes; 1 <= limit < UINT32_MAX.
// Returns how many steps all lanes did together.
uint64_t escape(const struct primitives *p, struct points c,
                uint32_t limit, uint32_t every, struct lanes *lanes,
                double *steps);
//<
