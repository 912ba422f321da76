//> Compare rules for phase two
// Where to look once somebody has been found: one layer further, as the
// report estimates; at as many layers as it is cells to whoever was met
// first, as it says; at whole layers, as far as D reaches; at the cells
// that meet the square; or at those that meet it while it shrinks with
// every better point. Distances and cells a point, and how many answers
// are wrong.
//
//     rules [POINTS]
#include "algorithms.h"
#include "ch02-all-pairs/timing.h"
#include "ch07-spiral/seek.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

enum rule {
    ONE_MORE,
    D_LAYERS,
    WHOLE_LAYERS,
    SQUARE,
    SHRINKING,
    RULES
};

static const char *const rule_names[] = {
    "one_more", "d_layers", "whole_layers", "square", "shrinking"};

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

// Layer k of the whole map.
INLINED void look_around(const struct map *map, int32_t k,
                         look_function *look, struct seeker *seeker)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    uint32_t column = axis_cell(x, seeker->x);
    uint32_t row = axis_cell(y, seeker->y);
    struct window all = {view_all(x, column), view_all(y, row)};
    look_at_layer(STANDARD, map, column, row, &all, k, look, seeker);
}

//> Meet whoever comes first
// Phase one as the report puts it: somebody in the first cell that is
// not empty. The cells are looked at when their layer's turn comes.
INLINED void look_for_anybody(const enum geometry geometry,
                              const struct map *map, uint32_t cell,
                              struct seeker *seeker)
{
    const struct points p = map->points;
    const uint32_t *start = map->cells->start;
    for (uint32_t s = start[cell];
         s < start[cell + 1] && seeker->nearest == NOBODY; s++) {
        uint32_t j = map->cells->point[s];
        if (j == seeker->self)
            continue;
        seeker->nearest = j;
        seeker->best2 = pair2(geometry, map->space, p.x[j] - seeker->x,
                              p.y[j] - seeker->y)
                            .near2;
    }
}

static void seek_d_layers(const struct map *map, struct seeker *seeker)
{
    for (int32_t k = 0; seeker->nearest == NOBODY; k++)
        look_around(map, k, look_for_anybody, seeker);
    double scale = most(map->grid->x.scale, map->grid->y.scale);
    int32_t layers = ceil(sqrt(seeker->best2) * scale);
    for (int32_t k = 0; k <= layers; k++)
        look_around(map, k, look_at_cell, seeker);
}
//<

//> Seek in whole layers
// One layer further than the first that is not empty; or as long as a
// point outside can be as near as D.
static void seek_layers(enum rule rule, const struct map *map,
                        struct seeker *seeker)
{
    int32_t k = 0;
    while (seeker->nearest == NOBODY)
        look_around(map, k++, look_at_cell, seeker);
    const int32_t next = k;
    const double best2 = seeker->best2;
    for (;; k++) {
        double x = seeker->x, y = seeker->y;
        struct block block = block_of(map->grid, x, y, k - 1);
        double margin = block_margin(map->grid, &block, x, y);
        if (rule == ONE_MORE ? k > next : best2 < margin * margin)
            break;
        look_around(map, k, look_at_cell, seeker);
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
    else if (rule == D_LAYERS)
        seek_d_layers(map, seeker);
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
//<

int main(int argc, char **argv)
{
    fail_as("rules");
    uint32_t n = argument(argc, argv, 1, "POINTS", 100000, 2, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers right = answers_allocate(n);
    find_algorithm("cells")->run(&question, &right);
    report_provenance(stdout);
    puts("name\tn\tc\tdistances\tcells\twrong");
    for (int c = 1; c <= 3; c++) {
        struct grid grid = grid_fit(&question, c);
        struct cells cells = cells_sort(&grid, question.points);
        struct map map = {&grid, &cells, question.points,
                          question.space};
        for (enum rule rule = 0; rule < RULES; rule++)
            count_rule(rule, &map, right.nearest2, c);
        cells_free(&cells);
        grid_free(&grid);
    }
    answers_free(&right);
    points_free(&question.points);
    return 0;
}
//<
