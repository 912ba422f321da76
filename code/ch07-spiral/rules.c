//> Compare rules for phase two
// Where to look once a layer has shown a point: one layer further, as
// the report estimates; at whole layers, as far as D reaches; at the
// cells that meet the square; or at those that meet it while it shrinks
// with every better point. Distances and cells a point, and how many
// answers are wrong.
//
//     rules [POINTS]
#include "ch02-all-pairs/timing.h"
#include "ch07-spiral/seek.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

enum rule { ONE_MORE, WHOLE_LAYERS, SQUARE, SHRINKING, RULES };

static const char *const rule_names[] = {"one_more", "whole_layers",
                                         "square", "shrinking"};

//> Look while the square shrinks
// A cell with no point as near as the best is passed by. No cell of a
// window wraps round in the standard geometry.
INLINED void look_if_near(const enum geometry geometry,
                          const struct map *map, uint32_t cell,
                          struct seeker *seeker)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    uint32_t column = cell % x->count, row = cell / x->count;
    double dx = most(x->border[column] - seeker->x,
                     seeker->x - x->border[column + 1]);
    double dy = most(y->border[row] - seeker->y,
                     seeker->y - y->border[row + 1]);
    double margin = most(most(dx, dy), 0);
    if (margin * margin <= seeker->best2)
        look_at_cell(geometry, map, cell, seeker);
}
//<

//> Seek in whole layers
// One layer further than the first that is not empty; or as long as a
// point outside can be as near as D.
static void seek_layers(enum rule rule, const struct map *map,
                        struct seeker *seeker)
{
    const struct grid *grid = map->grid;
    uint32_t column = axis_cell(&grid->x, seeker->x);
    uint32_t row = axis_cell(&grid->y, seeker->y);
    struct window all = {view_all(&grid->x, column),
                         view_all(&grid->y, row)};
    int32_t k = 0;
    while (seeker->nearest == NOBODY)
        look_at_layer(STANDARD, map, column, row, &all, k++,
                      look_at_cell, seeker);
    const int32_t next = k;
    const double best2 = seeker->best2;
    for (;; k++) {
        double x = seeker->x, y = seeker->y;
        struct block block = block_of(grid, x, y, k - 1);
        double margin = block_margin(grid, &block, x, y);
        if (rule == ONE_MORE ? k > next : best2 < margin * margin)
            break;
        look_at_layer(STANDARD, map, column, row, &all, k, look_at_cell,
                      seeker);
    }
}
//<

static void seek_by(enum rule rule, const struct map *map,
                    struct seeker *seeker)
{
    if (rule == SQUARE)
        seek(STANDARD, map, look_at_cell, seeker);
    else if (rule == SHRINKING)
        seek(STANDARD, map, look_if_near, seeker);
    else
        seek_layers(rule, map, seeker);
}

//> Count what a rule looks at
static void count_rule(enum rule rule, const struct map *map,
                       const double *right2, double c)
{
    uint64_t met = 0, looked = 0, wrong = 0;
#pragma omp parallel for schedule(dynamic, 256) \
    reduction(+ : met, looked, wrong)
    for (uint32_t i = 0; i < map->points.n; i++) {
        struct seeker seeker = seeker_at(map->points, i);
        seek_by(rule, map, &seeker);
        met += seeker.met;
        looked += seeker.looked;
        wrong += seeker.best2 != right2[i];
    }
    double n = map->points.n;
    printf("%s_%g\t%u\t%g\t%.6g\t%.6g\t%llu\n", rule_names[rule], c,
           map->points.n, c, met / n, looked / n,
           (unsigned long long)wrong);
}

static double *right_answers(const struct map *map)
{
    double *right2 = allocate(map->points.n, sizeof *right2);
#pragma omp parallel for schedule(dynamic, 256)
    for (uint32_t i = 0; i < map->points.n; i++) {
        struct seeker seeker = seeker_at(map->points, i);
        seek(STANDARD, map, look_at_cell, &seeker);
        right2[i] = seeker.best2;
    }
    return right2;
}
//<

int main(int argc, char **argv)
{
    fail_as("rules", NULL);
    uint32_t n = argument(argc, argv, 1, "POINTS", 100000, 2, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    report_provenance(stdout);
    puts("name\tn\tc\tdistances\tcells\twrong");
    for (int c = 1; c <= 3; c++) {
        struct grid grid = grid_fit(&question, c);
        struct cells cells = cells_sort(&grid, question.points);
        struct map map = {&grid, &cells, question.points,
                          question.space};
        double *right2 = right_answers(&map);
        for (enum rule rule = 0; rule < RULES; rule++)
            count_rule(rule, &map, right2, c);
        free(right2);
        cells_free(&cells);
        grid_free(&grid);
    }
    points_free(&question.points);
    return 0;
}
//<
