//> Take the copy for the geometry
// Included once by each version of the kernels, behind its enter_in and
// compare_in, which take the geometry as a constant. TARGET says which
// instructions the copies may use.
#pragma once

TARGET
static void enter_cells(const struct map *map, struct strip *strip,
                        const struct tasks *tasks, int32_t dx,
                        int32_t dy)
{
    if (map->space.geometry == STANDARD)
        enter_in(STANDARD, map, strip, tasks, dx, dy);
    else
        enter_in(WRAPAROUND, map, strip, tasks, dx, dy);
}

TARGET
static void compare_points(const struct map *map, struct strip *strip)
{
    if (map->space.geometry == STANDARD)
        compare_in(STANDARD, map, strip);
    else
        compare_in(WRAPAROUND, map, strip);
}
//<
