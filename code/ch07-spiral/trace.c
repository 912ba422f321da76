//> Draw one search
// What one search looked at, as it went: its cells, in units of a cell,
// the phase and the layer of each; then the points of the map around
// it, the point that asks, the best that phase one knew, and the
// neighbor. Drawn is the first point that phase one shows something
// worth drawing: it ends in layer 1, and phase two looks further.
//
//     trace
#include "ch02-all-pairs/timing.h"
#include "ch07-spiral/seek.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

enum { POINTS = 1000, MOST_CELLS = 200 };

//> Keep a record of the cells
// A seeker with a notebook. It comes first, so that who looks for a
// seeker finds it.
struct recorder {
    struct seeker seeker;
    uint32_t cell[MOST_CELLS];
    struct seeker before[MOST_CELLS]; // as it stood before each
    int count;
};

INLINED void look_and_record(const enum geometry geometry,
                             const struct map *map, uint32_t cell,
                             struct seeker *seeker)
{
    struct recorder *recorder = (struct recorder *)seeker;
    if (recorder->count == MOST_CELLS)
        fail("a search of more than %d cells", MOST_CELLS);
    recorder->before[recorder->count] = *seeker;
    recorder->cell[recorder->count++] = cell;
    look_at_cell(geometry, map, cell, seeker);
}
//<

static int layer_of(const struct grid *grid, uint32_t cell,
                    uint32_t home)
{
    int m = grid->x.count;
    int dx = (int)(cell % m) - (int)(home % m);
    int dy = (int)(cell / m) - (int)(home / m);
    return more(dx < 0 ? -dx : dx, dy < 0 ? -dy : dy);
}

//> Find a search worth drawing
// Phase one ends in layer 1, phase two looks at some of layer 2 on one
// side only, and finds a better neighbor there. The layer in which the
// first point was met ends phase one.
static bool worth_drawing(const struct grid *grid,
                          const struct recorder *r, int *ends)
{
    uint32_t home = r->cell[0];
    *ends = 0;
    for (int k = 0; k < r->count; k++)
        if (r->before[k].nearest == NOBODY)
            *ends = layer_of(grid, r->cell[k], home);
    double best2 = INFINITY;
    int beyond = 0;
    for (int k = 0; k < r->count; k++)
        if (layer_of(grid, r->cell[k], home) <= *ends)
            best2 = k + 1 < r->count ? r->before[k + 1].best2
                                     : r->seeker.best2;
        else
            beyond++;
    return *ends == 1 && beyond >= 4 && beyond <= 9 &&
           r->seeker.best2 < best2;
}
//<

static void print_mark(const char *kind, const struct grid *grid,
                       double x, double y)
{
    printf("%s\t%.6g\t%.6g\t0\t0\t0\n", kind,
           (x - grid->x.low) * grid->x.scale,
           (y - grid->y.low) * grid->y.scale);
}

//> Print what the search saw
static void print_trace(const struct map *map, const struct recorder *r,
                        int ends)
{
    const struct grid *grid = map->grid;
    const struct points p = map->points;
    uint32_t columns = grid->x.count, first = NOBODY;
    for (int k = 0; k < r->count; k++) {
        uint32_t cell = r->cell[k];
        int layer = layer_of(grid, cell, r->cell[0]);
        if (layer > ends && first == NOBODY)
            first = r->before[k].nearest;
        printf("cell\t%u\t%u\t%d\t%d\t%d\n", cell % columns,
               cell / columns, k, layer, layer <= ends ? 1 : 2);
    }
    for (uint32_t i = 0; i < p.n; i++)
        print_mark("point", grid, p.x[i], p.y[i]);
    print_mark("query", grid, r->seeker.x, r->seeker.y);
    print_mark("first", grid, p.x[first], p.y[first]);
    print_mark("neighbor", grid, p.x[r->seeker.nearest],
               p.y[r->seeker.nearest]);
}
//<

int main(void)
{
    fail_as("trace");
    struct question question = uniform_question(STANDARD, POINTS, 7);
    struct grid grid = grid_fit(&question, 1);
    struct cells cells = cells_sort(&grid, question.points);
    struct map map = {&grid, &cells, question.points, question.space};
    report_provenance(stdout);
    puts("kind\tx\ty\tstep\tlayer\tphase");
    for (uint32_t i = 0; i < POINTS; i++) {
        struct recorder recorder = {.seeker =
                                        seeker_at(question.points, i)};
        int ends;
        seek(STANDARD, &map, look_and_record, &recorder.seeker);
        if (worth_drawing(&grid, &recorder, &ends)) {
            print_trace(&map, &recorder, ends);
            break;
        }
    }
    cells_free(&cells);
    grid_free(&grid);
    points_free(&question.points);
    return 0;
}
//<
