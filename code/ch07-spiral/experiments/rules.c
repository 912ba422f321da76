// Compares rules for phase two: one layer more than phase one, as the
// report estimates; as many layers as it is cells to the first point
// found, as it says; whole layers, as far as D reaches; the cells that
// meet the square; or those that meet it while it shrinks with every
// better point. And the square once more, with the D of the report.
// Distances and cells a point, and wrong answers.
//     rules [POINTS]
#include "ch07-spiral/spiral_search.h"
#include "common/experiment.h"

enum rule {
    ONE_MORE,
    D_LAYERS,
    WHOLE_LAYERS,
    SQUARE,
    SHRINKING,
    FIRST_SQUARE,
    RULES
};

static const char *const rule_names[] = {
    "one_more", "d_layers",  "whole_layers",
    "square",   "shrinking", "first_square"};

// While the square shrinks: a cell that can have no point as near as
// the best is passed by.
INLINED void visit_if_near(const enum geometry geometry,
                           const struct map *map, uint32_t cell,
                           struct spiral_query *query)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    uint32_t column = cell % x->count, row = cell / x->count;
    double dx = MAX(x->border[column] - query->x,
                    query->x - x->border[column + 1]);
    double dy =
        MAX(y->border[row] - query->y, query->y - y->border[row + 1]);
    double margin = MAX(MAX(dx, dy), 0);
    if (margin * margin <= query->best2)
        visit_cell(geometry, map, cell, query);
}

// Layer k of the whole map.
INLINED void visit_around(const struct map *map, int32_t k,
                          spiral_visit *visit,
                          struct spiral_query *query)
{
    struct search_box whole = {
        whole_range(&map->grid->x, query->column),
        whole_range(&map->grid->y, query->row)};
    visit_layer(STANDARD, map, &whole, k, visit, query);
}

// Phase one as the report puts it: some point of the first cell that is
// not empty. The cells are visited when their layer's turn comes.
INLINED void take_first_point(const enum geometry geometry,
                              const struct map *map, uint32_t cell,
                              struct spiral_query *query)
{
    const struct points p = map->points;
    const uint32_t *start = map->cells->start;
    for (uint32_t s = start[cell];
         s < start[cell + 1] && query->nearest == NO_INDEX; s++) {
        uint32_t j = map->cells->point[s];
        if (j == query->self)
            continue;
        query->nearest = j;
        query->best2 = pair2(geometry, map->space, p.x[j] - query->x,
                             p.y[j] - query->y)
                           .near2;
    }
}

static void find_first_point(const struct map *map,
                             struct spiral_query *query)
{
    for (int32_t k = 0; query->nearest == NO_INDEX; k++)
        visit_around(map, k, take_first_point, query);
}

// The cells that meet the square around that point's distance.
static void search_first_square(const struct map *map,
                                struct spiral_query *query)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    find_first_point(map, query);
    struct search_box square = {
        square_range(STANDARD, x, whole_range(x, query->column),
                     query->column, query->x, query->best2),
        square_range(STANDARD, y, whole_range(y, query->row),
                     query->row, query->y, query->best2)};
    int32_t last = MAX(MAX(square.x.back, square.x.ahead),
                       MAX(square.y.back, square.y.ahead));
    for (int32_t k = 0; k <= last; k++)
        visit_layer(STANDARD, map, &square, k, visit_cell, query);
}

static void search_d_layers(const struct map *map,
                            struct spiral_query *query)
{
    find_first_point(map, query);
    double scale = MAX(map->grid->x.scale, map->grid->y.scale);
    int32_t layers = ceil(sqrt(query->best2) * scale);
    for (int32_t k = 0; k <= layers; k++)
        visit_around(map, k, visit_cell, query);
}

// One layer further than the first that is not empty; or as long as a
// point outside can be as near as D.
static void search_layers(enum rule rule, const struct map *map,
                          struct spiral_query *query)
{
    int32_t k = 0;
    while (query->nearest == NO_INDEX)
        visit_around(map, k++, visit_cell, query);
    const int32_t next = k;
    const double best2 = query->best2;
    for (;; k++) {
        double x = query->x, y = query->y;
        struct block block = block_of(map->grid, x, y, k - 1);
        double margin = block_margin(map->grid, &block, x, y);
        if (rule == ONE_MORE ? k > next : best2 < margin * margin)
            break;
        visit_around(map, k, visit_cell, query);
    }
}

static void search_by(enum rule rule, const struct map *map,
                      struct spiral_query *query)
{
    if (rule == SQUARE)
        spiral_nearest(STANDARD, map, visit_cell, query);
    else if (rule == SHRINKING)
        spiral_nearest(STANDARD, map, visit_if_near, query);
    else if (rule == D_LAYERS)
        search_d_layers(map, query);
    else if (rule == FIRST_SQUARE)
        search_first_square(map, query);
    else
        search_layers(rule, map, query);
}

// What the rule visits.
static void count_rule(enum rule rule, const struct map *map,
                       const double *right2, double c)
{
    uintmax_t distances = 0, visited = 0, wrong = 0;
#pragma omp parallel for schedule(dynamic, 256) \
    reduction(+ : distances, visited, wrong)
    for (uint32_t i = 0; i < map->points.n; i++) {
        struct spiral_query query = spiral_query_at(map, i);
        search_by(rule, map, &query);
        distances += query.distances;
        visited += query.cells;
        wrong += query.best2 != right2[i];
    }
    double n = map->points.n;
    row("%s_%g\t%u\t%g\t%.6g\t%.6g\t%ju", rule_names[rule], c,
        map->points.n, c, distances / n, visited / n, wrong);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *right = new_answers(n, BOTH);
    find_algorithm("cells")->run(&question, right);
    print_header(&e, "name n c distances cells wrong");
    for (int c = 1; c <= 3; c++) {
        struct grid grid = grid_fit(&question, c);
        struct cells cells = cells_sort(&grid, question.points);
        struct map map = {&grid, &cells, question.points,
                          question.space};
        for (enum rule rule = 0; rule < RULES; rule++)
            count_rule(rule, &map, right->nearest2, c);
        cells_free(&cells);
        grid_free(&grid);
    }
}
