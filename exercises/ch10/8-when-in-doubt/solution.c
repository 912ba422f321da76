// Andrew's chains propose, and a margin decides: a point goes if it
// lies above a side of the lower chain and below one of the upper
// chain, by more than a millionth of the box. The square of that is far
// above any rounding.
#include "exercise.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

//- solution
struct place {
    double x, y;
    uint32_t index;
    bool near; // to a side of a chain
};

static int from_left(const void *one, const void *other)
{
    const struct place *p = one, *q = other;
    const double a = p->x == q->x ? p->y : p->x;
    const double b = p->x == q->x ? q->y : q->x;
    return (a > b) - (a < b);
}

// By how much b is left of the line from a to c, times the length of
// that line.
static double height(const struct place *a, const struct place *b,
                     const struct place *c)
{
    return (c->x - a->x) * (b->y - a->y) -
           (c->y - a->y) * (b->x - a->x);
}

// Whether place k is further inside of a side than a margin.
static bool is_inside(const struct place *place, uint32_t k,
                      const uint32_t *side, double margin, int sign)
{
    const struct place *a = &place[side[0]], *c = &place[side[1]];
    return sign * height(a, &place[k], c) >
           margin * hypot(c->x - a->x, c->y - a->y);
}

// Makes the lower chain, or the upper one if the sign is less than 0,
// and notes which places are near to it.
static void note_near(struct place *place, uint32_t n, double margin,
                      int sign, uint32_t *chain)
{
    uint32_t count = 0, side = 0;
    for (uint32_t k = 0; k < n; k++) {
        while (count > 1 &&
               sign * height(&place[chain[count - 2]],
                             &place[chain[count - 1]], &place[k]) >=
                   0)
            count--;
        chain[count++] = k;
    }
    for (uint32_t k = 0; k < n; k++) {
        while (side + 2 < count &&
               place[chain[side + 1]].x < place[k].x)
            side++;
        if (count < 2 ||
            !is_inside(place, k, &chain[side], margin, sign))
            place[k].near = true;
    }
}

static double margin_of(const struct place *place, uint32_t n)
{
    double low = place[0].y, high = place[0].y;
    for (uint32_t k = 0; k < n; k++) {
        low = fmin(low, place[k].y);
        high = fmax(high, place[k].y);
    }
    return 0x1p-20 * hypot(place[n - 1].x - place[0].x, high - low);
}

//- starter
//- end
uint32_t keep_furthest(struct points points, uint32_t *kept)
{
    //- solution
    const uint32_t n = points.n;
    struct place *place = malloc(n * sizeof *place);
    uint32_t *chain = malloc(n * sizeof *chain), count = 0;
    if (!place || !chain)
        abort();
    for (uint32_t i = 0; i < n; i++)
        place[i] = (struct place){points.x[i], points.y[i], i, false};
    qsort(place, n, sizeof *place, from_left);
    const double margin = margin_of(place, n);
    note_near(place, n, margin, 1, chain);
    note_near(place, n, margin, -1, chain);
    for (uint32_t k = 0; k < n; k++)
        if (place[k].near)
            kept[count++] = place[k].index;
    free(chain);
    free(place);
    return count;
    //- starter
    // // Your turn: so far all are kept, but for the last half.
    // uint32_t count = 0;
    // for (uint32_t i = 0; i < points.n / 2 + 1; i++)
    //     kept[count++] = i;
    // return count;
    //- end
}
