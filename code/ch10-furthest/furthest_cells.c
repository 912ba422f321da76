//> Search the cells from outside
// See furthest_cells.h.
#include "ch10-furthest/furthest_cells.h"
#include "ch09-row-spans/carry.h"
#include "ch10-furthest/outside.h"
#include "common/clock.h"
#include "common/fail.h"
#include <stdlib.h>

#ifdef COUNTING
#define search_furthest_cells counting_search_furthest_cells
#endif

//> Find the rows that have points
struct rows rows_find(const struct sorted *sorted)
{
    const uint32_t columns = sorted->grid.x.count;
    const uint32_t n = sorted->grid.y.count;
    const uint32_t *start = sorted->cells.start;
    struct rows rows = {0, allocate(n, sizeof *rows.row),
                        allocate(n, sizeof *rows.place)};
    for (uint32_t row = 0; row < n; row++) {
        rows.place[row] = rows.count;
        rows.row[rows.count] = row;
        rows.count += start[row * columns] < start[(row + 1) * columns];
    }
    return rows;
}

void rows_free(struct rows *rows)
{
    free(rows->place);
    free(rows->row);
    *rows = (struct rows){0};
}
//<

//> Seek for some of the sorted points
INLINED void seek_for_some(const enum geometry geometry,
                           const struct ground *ground, uint32_t begin,
                           uint32_t end, struct answers *answers)
{
    for (uint32_t s = begin; s < end; s++) {
        struct viewer viewer = viewer_of(ground->sorted, s);
        seek_far(geometry, look_at, ground, &viewer);
        answers->furthest[viewer.self] = viewer.furthest;
        answers->furthest2[viewer.self] = viewer.most2;
    }
}
//<

//> Seek by all threads
void search_furthest_cells(const struct question *question,
                           const struct sorted *sorted,
                           struct answers *answers)
{
    enum { TURN = 256 };
    const uint32_t n = sorted->points.n, turns = (n - 1) / TURN + 1;
    struct rows rows = rows_find(sorted);
    const struct ground ground = {sorted, &rows, question->space};
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic)
    for (uint32_t turn = 0; turn < turns; turn++) {
        uint32_t begin = turn * TURN;
        uint32_t end = n - begin < TURN ? n : begin + TURN;
        if (question->space.geometry == STANDARD)
            seek_for_some(STANDARD, &ground, begin, end, answers);
        else
            seek_for_some(WRAPAROUND, &ground, begin, end, answers);
    }
    rows_free(&rows);
}

void furthest_cells(const struct question *question,
                    struct answers *answers)
{
    struct carried carried =
        carry_points(question, POINTS_PER_FAR_CELL);
    answers->built_ns = clock_ns();
    search_furthest_cells(question, &carried.sorted, answers);
    carried_free(&carried);
}
//<
//<
