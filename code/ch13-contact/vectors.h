//> Compute with vectors
// Products and differences of vectors in space.
#pragma once
#include "common/min_max.h"
#include <math.h>

static inline double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const double a[3], const double b[3],
                         double product[3])
{
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

static inline void subtract(const double a[3], const double b[3],
                            double difference[3])
{
    for (int k = 0; k < 3; k++)
        difference[k] = a[k] - b[k];
}

// The largest coordinate, without its sign.
static inline double largest(const double a[3])
{
    const double x = fabs(a[0]), y = fabs(a[1]), z = fabs(a[2]);
    const double more = MAX(x, y);
    return MAX(more, z);
}
//<
