//> Measure four or eight pairs
// The nearer of the two squared distances that pair2 measures, bitwise,
// in vectors.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "common/isa.h"
#include <immintrin.h>

//> Measure four pairs
USE_AVX2
INLINED __m256d four_near2(const enum geometry geometry,
                           struct space space, __m256d dx, __m256d dy)
{
    __m256d ax2 = _mm256_mul_pd(dx, dx), ay2 = _mm256_mul_pd(dy, dy);
    if (geometry == STANDARD)
        return _mm256_add_pd(ax2, ay2);
    const __m256d sign = _mm256_set1_pd(-0.0);
    __m256d bx = _mm256_sub_pd(_mm256_set1_pd(space.width),
                               _mm256_andnot_pd(sign, dx));
    __m256d by = _mm256_sub_pd(_mm256_set1_pd(space.height),
                               _mm256_andnot_pd(sign, dy));
    return _mm256_add_pd(_mm256_min_pd(ax2, _mm256_mul_pd(bx, bx)),
                         _mm256_min_pd(ay2, _mm256_mul_pd(by, by)));
}
//<

//> Measure eight distances
USE_AVX512
INLINED __m512d eight_near2(const enum geometry geometry,
                            struct space space, __m512d dx, __m512d dy)
{
    __m512d xx = _mm512_mul_pd(dx, dx), yy = _mm512_mul_pd(dy, dy);
    if (geometry == WRAPAROUND) {
        //> Take the shorter way round, in eight lanes
        __m512d bx = _mm512_sub_pd(_mm512_set1_pd(space.width),
                                   _mm512_abs_pd(dx));
        __m512d by = _mm512_sub_pd(_mm512_set1_pd(space.height),
                                   _mm512_abs_pd(dy));
        xx = _mm512_min_pd(xx, _mm512_mul_pd(bx, bx));
        yy = _mm512_min_pd(yy, _mm512_mul_pd(by, by));
        //<
    }
    return _mm512_add_pd(xx, yy);
}
//<
//<
