//> Go along in plain C
// See tile.h: loops over eight lanes, for whatever vectors there are.
#include "ch09-row-spans/portable_spans.h"
#include "ch09-row-spans/tile.h"

INLINED void stage(const struct sorted *sorted, uint32_t begin,
                   uint32_t end, double x, double y,
                   struct table *table)
{
    stage_plainly(sorted, begin, end, x, y, table->count, table);
    table->count += end - begin;
}

//> Give a distance a number
static inline float numbered(float d2, uint32_t number)
{
    uint32_t bits;
    memcpy(&bits, &d2, sizeof bits);
    bits = (bits & ~(uint32_t)NUMBER_BITS) | number;
    memcpy(&d2, &bits, sizeof bits);
    return d2;
}
//<

//> Sift in plain C
INLINED void sift(const struct table *table, struct sieve *sieve)
{
    struct sieve s;
    for (int lane = 0; lane < ASKING; lane++)
        s.best[lane] = s.second[lane] = FAR2;
    for (uint32_t k = 0; k < table->count; k++) {
        const uint32_t self = k;
#pragma omp simd
        for (uint32_t lane = 0; lane < ASKING; lane++) {
            float dx = table->x[k] - table->x[lane];
            float dy = table->y[k] - table->y[lane];
            float d2 = numbered(dx * dx + dy * dy, k);
            d2 = lane == self ? FAR2 : d2;
            float best = s.best[lane], second = s.second[lane];
            float loser = best > d2 ? best : d2;
            s.best[lane] = best < d2 ? best : d2;
            s.second[lane] = second < loser ? second : loser;
        }
    }
    *sieve = s;
}
//<

//> Meet one at a time
INLINED void meet(const enum geometry geometry, struct space space,
                  const struct sorted *sorted, uint32_t begin,
                  uint32_t end, struct single *single)
{
    const struct points p = sorted->points;
    for (uint32_t s = begin; s < end; s++) {
        double near2 = pair2(geometry, space, p.x[s] - single->x,
                             p.y[s] - single->y)
                           .near2;
        if (sorted->cells.point[s] != single->self)
            single_keep(single, near2, sorted->cells.point[s]);
    }
}
//<

void portable_spans(const struct question *question,
                    const struct sorted *sorted, enum manner manner,
                    const struct visit *visit, uint32_t begin,
                    uint32_t end, struct answers *found)
{
    if (question->space.geometry == STANDARD)
        go(STANDARD, stage, sift, meet, question->space, sorted, manner,
           visit, begin, end, found);
    else
        go(WRAPAROUND, stage, sift, meet, question->space, sorted,
           manner, visit, begin, end, found);
}
//<
