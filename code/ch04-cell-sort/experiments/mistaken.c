// Searches blocks of nine cells without the test, and with it, and
// prints the first point for which the two differ: the points, the
// borders, the block that was searched, and both neighbors.
#include "ch04-cell-sort/block.h"
#include "ch04-cell-sort/experiments/nine_cells.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/experiment.h"

static uint32_t first_mistaken(const struct answers *right,
                               const struct answers *found, uint32_t n)
{
    uint32_t i = 0;
    while (i < n && (right->nearest[i] == found->nearest[i] ||
                     found->nearest[i] == NO_INDEX))
        i++;
    return i;
}

static void print_point(const char *kind, struct points p, uint32_t i)
{
    row("%s\t%.6f\t%.6f", kind, p.x[i], p.y[i]);
}

static void print_picture(const struct grid *grid, struct points p,
                          uint32_t i, uint32_t found, uint32_t right)
{
    struct block block = block_of(grid, p.x[i], p.y[i], 1);
    const double *x = grid->x.border, *y = grid->y.border;
    for (uint32_t j = 0; j < p.n; j++)
        print_point("point", p, j);
    for (uint32_t k = 0; k <= grid->x.count; k++)
        row("column\t%.6f\t0", x[k]);
    for (uint32_t k = 0; k <= grid->y.count; k++)
        row("row\t0\t%.6f", y[k]);
    row("low\t%.6f\t%.6f", x[block.x.first], y[block.y.first]);
    row("high\t%.6f\t%.6f", x[block.x.first + block.x.count],
        y[block.y.first + block.y.count]);
    print_point("query", p, i);
    print_point("found", p, found);
    print_point("right", p, right);
}

int main(int argc, char **argv)
{
    enum { POINTS = 64 };
    struct experiment e = experiment_begin(argc, argv);
    uint32_t i = POINTS;
    print_header(&e, "kind x y");
    for (uint64_t seed = 1; i == POINTS; seed++) {
        struct question question =
            uniform_question(STANDARD, POINTS, seed);
        struct answers *right = new_answers(POINTS, NEAREST);
        struct answers *found = new_answers(POINTS, NEAREST);
        struct sorted sorted = sorted_make(&question, 1);
        search_nine_cells(&question, &sorted, found);
        search_sorted(&question, &sorted, right);
        i = first_mistaken(right, found, POINTS);
        if (i < POINTS)
            print_picture(&sorted.grid, question.points, i,
                          found->nearest[i], right->nearest[i]);
        sorted_free(&sorted);
        forget();
    }
}
