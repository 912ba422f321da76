// What the trick looked at for two points: one that it answers right,
// and one whose furthest point it misses since the corner cell is
// empty. In units of cells: the cells, the points, the circle.
#include "ch02-all-pairs/naive.h"
#include "ch10-furthest/coursework_furthest.h"
#include "common/experiment.h"

enum { POINTS = 200, MOST_SEEDS = 10000 };

static void print_place(const char *panel, const char *kind,
                        const struct grid *grid, double x, double y)
{
    row("%s_%s\t%.6g\t%.6g", panel, kind,
        (x - grid->x.low) * grid->x.scale,
        (y - grid->y.low) * grid->y.scale);
}

static void print_search(const char *panel, const struct sorted *sorted,
                         const struct points p, uint32_t query,
                         uint32_t found, uint32_t right)
{
    const struct grid *grid = &sorted->grid;
    struct circle circle = circle_around(grid, p.x[query], p.y[query]);
    row("%s_grid\t%u\t%u", panel, grid->x.count, grid->y.count);
    for (uint32_t line = 0; line < grid->y.count; line++)
        for (uint32_t column = 0; column < grid->x.count; column++)
            if (partly_outside(grid, &circle, column, line))
                row("%s_cell\t%u\t%u", panel, column, line);
    for (uint32_t i = 0; i < p.n; i++)
        print_place(panel, "point", grid, p.x[i], p.y[i]);
    print_place(panel, "query", grid, p.x[query], p.y[query]);
    print_place(panel, "found", grid, p.x[found], p.y[found]);
    print_place(panel, "right", grid, p.x[right], p.y[right]);
    double radius = sqrt(circle.radius2);
    row("%s_radius\t%.6g\t%.6g", panel, radius * grid->x.scale,
        radius * grid->y.scale);
}

// In the lower left quarter; found by the trick or missed, as wanted.
static uint32_t worth_drawing(const struct points p,
                              const struct answers *found,
                              const struct answers *right, bool missed)
{
    for (uint32_t i = 0; i < p.n; i++)
        if (p.x[i] > 0.05 && p.x[i] < 0.15 && p.y[i] > 0.22 &&
            p.y[i] < 0.32 && found->furthest[i] < p.n &&
            (found->furthest2[i] < right->furthest2[i]) == missed)
            return i;
    return p.n;
}

static void draw(const char *panel, bool missed)
{
    uint32_t query = POINTS;
    for (uint64_t seed = 1; query == POINTS; seed++) {
        if (seed > MOST_SEEDS)
            fail("no search worth drawing");
        struct question question =
            uniform_question(STANDARD, POINTS, seed);
        struct answers *found = new_answers(POINTS, BOTH);
        struct answers *right = new_answers(POINTS, BOTH);
        struct sorted sorted = sorted_make(&question, 2);
        search_one_corner(&question, &sorted, found);
        naive(&question, right);
        query = worth_drawing(question.points, found, right, missed);
        if (query < POINTS)
            print_search(panel, &sorted, question.points, query,
                         found->furthest[query],
                         right->furthest[query]);
        sorted_free(&sorted);
        forget();
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    print_header(&e, "kind x y");
    draw("sound", false);
    draw("broken", true);
}
