//> Sweep in plain C
// The plain program beside which the vector kernels stand: loops over
// eight lanes, for whatever vectors there are. What is compared is a
// function of dx and dy, the less, the better: chapter 10 brings
// another one.
#pragma once
#include "ch09-row-spans/batch.h"

//> Declare what a sweep measures
typedef float plain_measure(const struct scene *scene, float dx,
                            float dy);
//<

//> Put a place into the low bits
static inline float with_place(float value, uint32_t place)
{
    union {
        float value;
        uint32_t bits;
    } number = {value};
    number.bits = (number.bits & ~(uint32_t)PLACE_MASK) | place;
    return number.value;
}
//<

//> Compare all lanes with a candidate
INLINED void compare_lanes(plain_measure *measure,
                           const struct scene *scene,
                           const struct staging *staging, uint32_t own,
                           uint32_t place, struct best_two *two)
{
    const float *x = staging->place_x, *y = staging->place_y;
#pragma omp simd
    for (uint32_t lane = 0; lane < BATCH; lane++) {
        float value = measure(scene, x[place] - x[own + lane],
                              y[place] - y[own + lane]);
        value = place == own + lane ? FAR2 : with_place(value, place);
        float best = two->best[lane], second = two->second[lane];
        float loser = best > value ? best : value;
        two->best[lane] = best < value ? best : value;
        two->second[lane] = second < loser ? second : loser;
    }
}
//<

//> Sweep over three row spans
INLINED struct best_two sweep_plainly(plain_measure *measure,
                                      const struct scene *scene,
                                      const struct staging *staging,
                                      const struct query_batch *batch)
{
    struct best_two two;
    for (int lane = 0; lane < BATCH; lane++)
        two.best[lane] = two.second[lane] = FAR2;
    for (int r = 0; r < ROWS; r++)
        for (uint32_t k = batch->from[r]; k < batch->to[r]; k++)
            compare_lanes(measure, scene, staging, batch->own, k, &two);
    return two;
}
//<

//> Tell one candidate from the next
INLINED bool is_certain(const struct best_two *two, int lane,
                        float slack)
{
    return two->second[lane] >
           two->best[lane] * (1 + RELATIVE_SLACK) + slack;
}
//<
//<
