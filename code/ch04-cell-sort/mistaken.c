//> Draw a wrong neighbor
// Searches blocks of nine cells without the test, and with it, and
// prints the first point for which the two differ: the points, the
// borders, the block that was looked at, and both neighbors.
//
//     mistaken
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/block.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

//> Find the first who is mistaken
static uint32_t first_mistaken(const struct answers *right,
                               const struct answers *found, uint32_t n)
{
    uint32_t i = 0;
    while (i < n && (right->nearest[i] == found->nearest[i] ||
                     found->nearest[i] == NOBODY))
        i++;
    return i;
}
//<

static void print_point(const char *kind, struct points p, uint32_t i)
{
    printf("%s\t%.6f\t%.6f\n", kind, p.x[i], p.y[i]);
}

static void print_picture(const struct grid *grid, struct points p,
                          uint32_t i, uint32_t found, uint32_t right)
{
    struct block block = block_of(grid, p.x[i], p.y[i], 1);
    const double *x = grid->x.border, *y = grid->y.border;
    report_provenance(stdout);
    puts("kind\tx\ty");
    for (uint32_t j = 0; j < p.n; j++)
        print_point("point", p, j);
    for (uint32_t k = 0; k <= grid->x.count; k++)
        printf("column\t%.6f\t0\n", x[k]);
    for (uint32_t k = 0; k <= grid->y.count; k++)
        printf("row\t0\t%.6f\n", y[k]);
    printf("low\t%.6f\t%.6f\n", x[block.x.first], y[block.y.first]);
    printf("high\t%.6f\t%.6f\n", x[block.x.first + block.x.count],
           y[block.y.first + block.y.count]);
    print_point("asks", p, i);
    print_point("found", p, found);
    print_point("right", p, right);
}

int main(void)
{
    enum { POINTS = 64 };
    fail_as("mistaken");
    struct answers right = answers_allocate(POINTS);
    struct answers found = answers_allocate(POINTS);
    uint32_t i = POINTS;
    for (uint64_t seed = 1; i == POINTS; seed++) {
        struct question question =
            uniform_question(STANDARD, POINTS, seed);
        struct points p = question.points;
        struct sorted sorted =
            sorted_make(&question, 1, cells_sort_alone);
        search_untested(&question, &sorted, &found);
        search_sorted(&question, &sorted, &right);
        i = first_mistaken(&right, &found, POINTS);
        if (i < POINTS)
            print_picture(&sorted.grid, p, i, found.nearest[i],
                          right.nearest[i]);
        sorted_free(&sorted);
        points_free(&question.points);
    }
    answers_free(&right);
    answers_free(&found);
    return 0;
}
//<
