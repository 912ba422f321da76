// No two sides of a hull have the same direction, so the shortest step
// of each direction, sorted by angle, makes most of the room there is.
#include "exercise.h"
#include <stdlib.h>

//- solution
struct step {
    uint32_t a, b;
};

static uint32_t common_divisor(uint32_t a, uint32_t b)
{
    return b == 0 ? a : common_divisor(b, a % b);
}

// Steps to the right, and upward or level, the shortest first, as long
// as there is room for each and its three turns by a right angle.
static uint32_t choose(struct step *step, uint32_t most, uint32_t room)
{
    uint32_t count = 0;
    for (uint32_t sum = 1; sum <= room; sum++)
        for (uint32_t a = 1; a <= sum; a++) {
            uint32_t b = sum - a;
            if (common_divisor(a, b) > 1)
                continue;
            if (sum > room || count == most)
                return count;
            step[count++] = (struct step){a, b};
            room -= sum;
        }
    return count;
}

static int by_angle(const void *p, const void *q)
{
    const struct step *s = p, *t = q;
    uint32_t left = s->b * t->a, right = t->b * s->a;
    return (left > right) - (left < right);
}

//- starter
//- end
void worst_case(struct points points, uint32_t side)
{
    //- solution
    uint32_t most = points.n / 4, i = 0;
    struct step *step = malloc(most * sizeof *step);
    if (!step)
        abort();
    uint32_t count = choose(step, most, side);
    qsort(step, count, sizeof *step, by_angle);
    double x = 0, y = 0;
    for (uint32_t s = 0; s < count; s++)
        x += step[s].b; // as far as the last quarter goes back
    for (int quarter = 0; quarter < 4; quarter++)
        for (uint32_t s = 0; s < count; s++) {
            double a = step[s].a, b = step[s].b;
            points.x[i] = x;
            points.y[i] = y;
            i++;
            x += quarter == 0   ? a
                 : quarter == 1 ? -b
                 : quarter == 2 ? -a
                                : b;
            y += quarter == 0   ? b
                 : quarter == 1 ? a
                 : quarter == 2 ? -b
                                : -a;
        }
    for (; i < points.n; i++) {
        points.x[i] = points.x[0];
        points.y[i] = points.y[0];
    }
    free(step);
    //- starter
    // // Your turn: all of them lie along the border, and four are
    // // corners.
    // for (uint32_t i = 0; i < points.n; i++) {
    //     uint32_t along = i / 4 % side, edge = i % 4;
    //     points.x[i] = edge == 0   ? along
    //                   : edge == 1 ? side
    //                   : edge == 2 ? side - along
    //                               : 0;
    //     points.y[i] = edge == 0   ? 0
    //                   : edge == 1 ? along
    //                   : edge == 2 ? side
    //                               : side - along;
    // }
    //- end
}
