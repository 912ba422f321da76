// The points that are furthest out in eight directions make an octagon.
// What lies inside all of its sides is no corner, and goes.
#include "exercise.h"
#include <stdbool.h>

//- solution
enum { DIRECTIONS = 8 };

// Counterclockwise, an eighth of a turn from one to the next.
static const int across[DIRECTIONS] = {1, 1, 0, -1, -1, -1, 0, 1};
static const int up[DIRECTIONS] = {0, 1, 1, 1, 0, -1, -1, -1};

// A point is inside if a * x + b * y is greater than c.
struct side {
    double a, b, c;
};

static void find_extremes(struct points points, uint32_t *extreme)
{
    double most[DIRECTIONS];
    for (int e = 0; e < DIRECTIONS; e++) {
        extreme[e] = 0;
        most[e] = across[e] * points.x[0] + up[e] * points.y[0];
    }
    for (uint32_t i = 1; i < points.n; i++)
        for (int e = 0; e < DIRECTIONS; e++) {
            const double far =
                across[e] * points.x[i] + up[e] * points.y[i];
            if (far > most[e]) {
                most[e] = far;
                extreme[e] = i;
            }
        }
}

// A side from a point to itself has none inside: it is left out.
static int make_sides(struct points points, const uint32_t *extreme,
                      struct side *side)
{
    int sides = 0;
    for (int e = 0; e < DIRECTIONS; e++) {
        const uint32_t i = extreme[e];
        const uint32_t j = extreme[(e + 1) % DIRECTIONS];
        const double a = points.y[i] - points.y[j];
        const double b = points.x[j] - points.x[i];
        if (a != 0 || b != 0)
            side[sides++] =
                (struct side){a, b, a * points.x[i] + b * points.y[i]};
    }
    return sides;
}

static bool is_inside(const struct side *side, int sides, double x,
                      double y)
{
    for (int s = 0; s < sides; s++)
        if (!(side[s].a * x + side[s].b * y > side[s].c))
            return false;
    return sides > 0;
}

//- starter
//- end
uint32_t throw_away(struct points points, uint32_t *kept)
{
    //- solution
    uint32_t extreme[DIRECTIONS], count = 0;
    struct side side[DIRECTIONS];
    find_extremes(points, extreme);
    const int sides = make_sides(points, extreme, side);
    for (uint32_t i = 0; i < points.n; i++) {
        kept[count] = i;
        count += !is_inside(side, sides, points.x[i], points.y[i]);
    }
    return count;
    //- starter
    // // Your turn: so far every other point goes.
    // uint32_t count = 0;
    // for (uint32_t i = 0; i < points.n; i += 2)
    //     kept[count++] = i;
    // return count;
    //- end
}
