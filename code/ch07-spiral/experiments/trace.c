// Trace one search, cell by cell: for each cell that it visits its
// column and row, the layer, the phase, how many points were compared
// there, and the distance to the best so far, in cells (-: none). Then
// all points, the query, the nearest of phase one, and the neighbor.
// Taken is the first point whose search is worth drawing: phase one
// ends in layer 1, and phase two goes further and finds a nearer one.
//
//     trace
#include "ch07-spiral/two_phases.h"
#include "common/experiment.h"

enum { POINTS = 1000, MOST_CELLS = 200 };

// The query comes first, so that a pointer to it is one to the record.
struct recorder {
    struct spiral_query query;
    uint32_t cell[MOST_CELLS];
    struct spiral_query before[MOST_CELLS]; // as it stood before each
    int count;
};

INLINED void visit_and_record(const enum geometry geometry,
                              const struct map *map, uint32_t cell,
                              struct spiral_query *query)
{
    struct recorder *recorder = (struct recorder *)query;
    if (recorder->count == MOST_CELLS)
        fail("a search of more than %d cells", MOST_CELLS);
    recorder->before[recorder->count] = *query;
    recorder->cell[recorder->count++] = cell;
    visit_cell(geometry, map, cell, query);
}

static int layer_of(const struct grid *grid, uint32_t cell,
                    uint32_t home)
{
    int m = grid->x.count;
    int dx = (int)(cell % m) - (int)(home % m);
    int dy = (int)(cell / m) - (int)(home / m);
    return MAX(dx < 0 ? -dx : dx, dy < 0 ? -dy : dy);
}

// Phase one ends in layer 1; phase two visits some of layer 2, on one
// side only, and finds a better neighbor there. `ends` is the layer of
// the first point that was compared.
static bool worth_drawing(const struct grid *grid,
                          const struct recorder *r, int *ends)
{
    uint32_t home = r->cell[0];
    *ends = 0;
    for (int k = 0; k < r->count; k++)
        if (r->before[k].nearest == NO_INDEX)
            *ends = layer_of(grid, r->cell[k], home);
    double best2 = INFINITY;
    int beyond = 0;
    for (int k = 0; k < r->count; k++)
        if (layer_of(grid, r->cell[k], home) <= *ends)
            best2 = k + 1 < r->count ? r->before[k + 1].best2
                                     : r->query.best2;
        else
            beyond++;
    return *ends == 1 && beyond >= 4 && beyond <= 9 &&
           r->query.best2 < best2;
}

static void print_mark(const char *kind, const struct grid *grid,
                       double x, double y)
{
    row("%s\t%.6g\t%.6g\t0\t0\t0\t0\t0", kind,
        (x - grid->x.low) * grid->x.scale,
        (y - grid->y.low) * grid->y.scale);
}

static void print_trace(const struct map *map, const struct recorder *r,
                        int ends)
{
    const struct grid *grid = map->grid;
    const struct points p = map->points;
    uint32_t columns = grid->x.count, first = NO_INDEX;
    for (int k = 0; k < r->count; k++) {
        uint32_t cell = r->cell[k];
        int layer = layer_of(grid, cell, r->cell[0]);
        if (layer > ends && first == NO_INDEX)
            first = r->before[k].nearest;
        const struct spiral_query *before = &r->before[k];
        const struct spiral_query *after =
            k + 1 < r->count ? before + 1 : &r->query;
        row_begin("cell\t%u\t%u\t%d\t%d\t%d\t%ju\t", cell % columns,
                  cell / columns, k + 1, layer, layer <= ends ? 1 : 2,
                  (uintmax_t)(after->distances - before->distances));
        if (after->nearest == NO_INDEX)
            row("-");
        else
            row("%.3f", sqrt(after->best2) * grid->x.scale);
    }
    for (uint32_t i = 0; i < p.n; i++)
        print_mark("point", grid, p.x[i], p.y[i]);
    print_mark("query", grid, r->query.x, r->query.y);
    print_mark("first", grid, p.x[first], p.y[first]);
    print_mark("neighbor", grid, p.x[r->query.nearest],
               p.y[r->query.nearest]);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    struct question question = uniform_question(STANDARD, POINTS, 7);
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    struct map map = {&grid, &cells, question.points, question.space};
    columns(&e, "kind x y visit layer phase compared best");
    for (uint32_t i = 0; i < POINTS; i++) {
        struct recorder recorder = {.query = spiral_query_at(&map, i)};
        int ends;
        spiral_nearest(STANDARD, &map, visit_and_record,
                       &recorder.query);
        if (worth_drawing(&grid, &recorder, &ends)) {
            print_trace(&map, &recorder, ends);
            break;
        }
    }
    return 0;
}
