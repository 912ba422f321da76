// How often the cell so many steps away is visited, one point to a
// cell: counted on points that wrap around, and expected.
//     visits [POINTS]
#include "ch07-spiral/experiments/expected.h"
#include "ch07-spiral/spiral_search.h"
#include "common/experiment.h"

enum { FAR = 3, WIDE = 2 * FAR + 1 };

struct visitor {
    struct spiral_query query; // first: a pointer to it is one to all
    uint64_t visits[WIDE][WIDE];
};

static int32_t steps_to(const struct axis *axis, int32_t from,
                        int32_t to)
{
    int32_t m = axis->count, steps = to - from;
    return steps > m / 2    ? steps - m
           : steps < -m / 2 ? steps + m
                            : steps;
}

INLINED void visit_and_note(const enum geometry geometry,
                            const struct map *map, uint32_t cell,
                            struct spiral_query *query)
{
    struct visitor *visitor = (struct visitor *)query;
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    int32_t dx = steps_to(x, query->column, cell % x->count);
    int32_t dy = steps_to(y, query->row, cell / x->count);
    if (abs(dx) <= FAR && abs(dy) <= FAR)
        visitor->visits[FAR + dy][FAR + dx]++;
    visit_cell(geometry, map, cell, query);
}

static void visit_all(const struct map *map, struct visitor *visitor)
{
    for (uint32_t i = 0; i < map->points.n; i++) {
        visitor->query = spiral_query_at(map, i);
        spiral_nearest(WRAPAROUND, map, visit_and_note,
                       &visitor->query);
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    struct question question = uniform_question(WRAPAROUND, n, 1);
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    struct map map = {&grid, &cells, question.points, question.space};
    static struct visitor visitor;
    visit_all(&map, &visitor);
    print_header(&e, "name n dx dy counted expected");
    for (int dy = -FAR; dy <= FAR; dy++)
        for (int dx = -FAR; dx <= FAR; dx++)
            row("row%d_column%d\t%u\t%d\t%d\t%.6g\t%.6g", FAR + dy,
                FAR + dx, n, dx, dy,
                (double)visitor.visits[FAR + dy][FAR + dx] / n,
                dx || dy ? expected_visits(1, dx, dy) : 1);
}
