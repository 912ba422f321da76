//> Bound the searches of a strip
// Side by side: all tasks take a step away from their query's cell as
// long as the next cells may have a point at distance D or nearer;
// those whose square ends are packed away.
#include "ch08-vector-spiral/search_bounds.h"

//> Find the bounds on one side
INLINED void bound_side(const enum geometry geometry,
                        const struct axis axis, struct strip *strip,
                        const enum side side)
{
    const bool ahead = side == EAST || side == NORTH;
    const bool columns = side == WEST || side == EAST;
    const int32_t *cell = columns ? strip->all.column : strip->all.row;
    const double *x = columns ? strip->x : strip->y;
    const double *best2 = strip->best2;
    int32_t *bound = strip->all.bound[side];
    uint32_t *going = strip->cell, n = strip->all.n;
    uint8_t *keep = strip->keep;
    for (uint32_t t = 0; t < n; t++)
        going[t] = t;
    //> Take a step as long as the square goes on
    for (int32_t steps = 1; n > 0; steps++) {
        strip->tally.bound_steps += n;
        for (uint32_t i = 0; i < n; i++) {
            uint32_t t = going[i];
            struct search_range all = whole_range(&axis, cell[t]);
            double margin = ahead ? margin_ahead(geometry, &axis, all,
                                                 cell[t], steps, x[t])
                                  : margin_back(geometry, &axis, all,
                                                cell[t], steps, x[t]);
            keep[i] = (steps <= (ahead ? all.ahead : all.back)) &
                      (margin * margin <= best2[t]);
            bound[t] = steps - 1;
        }
        n = strip->primitives->pack(going, going, keep, n);
    }
    //<
}
//<

//> Find the bounds on all sides
INLINED void bound_in(const enum geometry geometry,
                      const struct map *map, struct strip *strip)
{
    bound_side(geometry, map->grid->x, strip, WEST);
    bound_side(geometry, map->grid->x, strip, EAST);
    bound_side(geometry, map->grid->y, strip, SOUTH);
    bound_side(geometry, map->grid->y, strip, NORTH);
}
//<

void bound_searches(const struct map *map, struct strip *strip)
{
    if (map->space.geometry == STANDARD)
        bound_in(STANDARD, map, strip);
    else
        bound_in(WRAPAROUND, map, strip);
}
//<
