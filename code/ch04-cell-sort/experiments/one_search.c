// One search over cells, and nothing else, for a simulator of branches
// and caches: `uniform` points or a `lattice`, C points in a cell, in
// the way named.
//
//     one_search KIND C WAY [POINTS]
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/experiment.h"
#include "common/fail.h"
#include <stdlib.h>
#include <string.h>

struct bench {
    struct question question;
    struct sorted sorted;
    struct lists lists;
    struct answers answers;
};

static void run(const struct bench *b, const char *way)
{
    struct answers answers = b->answers;
    const struct grid *grid = &b->sorted.grid;
    const struct cells *cells = &b->sorted.cells;
    if (strcmp(way, "lists") == 0)
        search_lists(&b->question, grid, &b->lists, NULL, &answers);
    else if (strcmp(way, "lists_in_order") == 0)
        search_lists(&b->question, grid, &b->lists, cells->point,
                     &answers);
    else if (strcmp(way, "indices") == 0)
        search_indices(&b->question, grid, cells, NULL, &answers);
    else if (strcmp(way, "indices_in_order") == 0)
        search_indices(&b->question, grid, cells, cells->point,
                       &answers);
    else if (strcmp(way, "sorted") == 0)
        search_sorted(&b->question, &b->sorted, &answers);
    else if (strcmp(way, "batches") == 0)
        search_batches(&b->question, &b->sorted, &answers);
    else
        fail("there is no way called %s", way);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    if (argc < 4)
        fail("usage: one_search KIND C WAY [POINTS]");
    e.next = 4; // behind those three
    uint32_t n = parameter(&e, "POINTS", 102400, 2, MANY);
    struct bench b = {.question = kind_question(argv[1], n, 1),
                      .answers = answers_allocate(n)};
    b.question.space.geometry = WRAPAROUND;
    b.sorted =
        sorted_make(&b.question, atof(argv[2]), cells_sort_alone);
    b.lists = lists_make(&b.sorted.grid, b.question.points);
    run(&b, argv[3]);
    lists_free(&b.lists);
    sorted_free(&b.sorted);
    answers_free(&b.answers);
    points_free(&b.question.points);
    return 0;
}
