// Trace one search, cell by cell: for each cell that it visits its
// column and row, the layer, the phase, how many points were compared
// there, and the distance to the best so far, in widths of a cell (-:
// none). Then all points, the query, the nearest of phase one, the
// neighbor, and D in widths and in heights of a cell.
// Taken is the first point whose search is worth drawing: phase one
// ends in layer 1, and phase two goes further and finds a nearer one.
#include "ch07-spiral/spiral_search.h"
#include "common/experiment.h"

enum { POINTS = 1000, MOST_CELLS = 200 };

// A visit of a cell, and how the search stood after it.
struct visit {
    uint32_t column, row, nearest;
    int layer;
    uint64_t compared; // points of the cell
    double best2;
};

// The query comes first, so that a pointer to it is one to the record.
struct recorder {
    struct spiral_query query;
    struct visit visits[MOST_CELLS];
    int count;
};

INLINED void visit_and_record(const enum geometry geometry,
                              const struct map *map, uint32_t cell,
                              struct spiral_query *query)
{
    struct recorder *recorder = (struct recorder *)query;
    if (recorder->count == MOST_CELLS)
        fail("a search of more than %d cells", MOST_CELLS);
    const int column = cell % map->grid->x.count;
    const int row = cell / map->grid->x.count;
    const uint64_t before = query->distances;
    visit_cell(geometry, map, cell, query);
    recorder->visits[recorder->count++] =
        (struct visit){column,
                       row,
                       query->nearest,
                       MAX(abs(column - (int)query->column),
                           abs(row - (int)query->row)),
                       query->distances - before,
                       query->best2};
}

// The visits of phase one, up to the end of the first layer that has a
// point.
static int phase_one(const struct recorder *r)
{
    int count = 0, found = 0;
    while (r->visits[found].nearest == NO_INDEX)
        found++;
    while (count < r->count &&
           r->visits[count].layer <= r->visits[found].layer)
        count++;
    return count;
}

// Phase one ends in layer 1; phase two visits some of layer 2, on one
// side only, and finds a better neighbor there.
static bool worth_drawing(const struct recorder *r)
{
    const int first = phase_one(r), beyond = r->count - first;
    const struct visit *last = &r->visits[first - 1];
    return last->layer == 1 && beyond >= 4 && beyond <= 9 &&
           r->query.best2 < last->best2;
}

static void print_pair(const char *kind, double x, double y)
{
    row("%s\t%.6g\t%.6g\t0\t0\t0\t0\t0", kind, x, y);
}

static void print_mark(const char *kind, const struct grid *grid,
                       double x, double y)
{
    print_pair(kind, (x - grid->x.low) * grid->x.scale,
               (y - grid->y.low) * grid->y.scale);
}

static void print_trace(const struct map *map, const struct recorder *r)
{
    const struct grid *grid = map->grid;
    const struct points p = map->points;
    const int first = phase_one(r);
    for (int k = 0; k < r->count; k++) {
        const struct visit *v = &r->visits[k];
        row_begin("cell\t%u\t%u\t%d\t%d\t%d\t%ju\t", v->column, v->row,
                  k + 1, v->layer, k < first ? 1 : 2,
                  (uintmax_t)v->compared);
        if (v->nearest == NO_INDEX)
            row("-");
        else
            row("%.3f", sqrt(v->best2) * grid->x.scale);
    }
    for (uint32_t i = 0; i < p.n; i++)
        print_mark("point", grid, p.x[i], p.y[i]);
    uint32_t near = r->visits[first - 1].nearest, i = r->query.nearest;
    print_mark("query", grid, r->query.x, r->query.y);
    print_mark("first", grid, p.x[near], p.y[near]);
    print_mark("neighbor", grid, p.x[i], p.y[i]);
    const double d = sqrt(r->visits[first - 1].best2);
    print_pair("square", d * grid->x.scale, d * grid->y.scale);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    struct question question = uniform_question(STANDARD, POINTS, 7);
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    struct map map = {&grid, &cells, question.points, question.space};
    print_header(&e, "kind x y visit layer phase compared best");
    for (uint32_t i = 0; i < POINTS; i++) {
        struct recorder recorder = {.query = spiral_query_at(&map, i)};
        spiral_nearest(STANDARD, &map, visit_and_record,
                       &recorder.query);
        if (worth_drawing(&recorder)) {
            print_trace(&map, &recorder);
            break;
        }
    }
}
