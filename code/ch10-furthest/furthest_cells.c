//> Search the cells from outside
// See furthest_cells.h.
#include "ch10-furthest/furthest_cells.h"
#include "ch09-row-spans/send_back.h"
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

//> Say whether eight stand together
// In one row, so that with wraparound their homes are one stretch, and
// a short one, for it is looked at first.
static bool stand_together(const struct sorted *sorted, uint32_t s,
                           uint32_t end)
{
    if (end - s < ABREAST)
        return false;
    const uint32_t last = s + ABREAST - 1;
    const struct axis *across = &sorted->grid.x, *up = &sorted->grid.y;
    const double *x = sorted->points.x, *y = sorted->points.y;
    return axis_cell(up, y[s]) == axis_cell(up, y[last]) &&
           axis_cell(across, x[last]) <
               axis_cell(across, x[s]) + ABREAST;
}
//<

//> Seek together or alone
// For as many of the sorted points as there are lanes, from s on.
INLINED void seek_for(const enum geometry geometry,
                      const uint32_t lanes, const struct ground *ground,
                      uint32_t s, uint32_t *furthest, double *furthest2)
{
    struct viewers viewers;
    set_viewers(lanes, ground->sorted, s, &viewers);
    seek_far(geometry, lanes, ground, &viewers);
    for (uint32_t lane = 0; lane < lanes; lane++) {
        furthest[lane] = (uint32_t)viewers.furthest[lane];
        furthest2[lane] = viewers.most2[lane];
    }
}
//<

//> Seek for some of the sorted points
INLINED void seek_for_some(const enum geometry geometry,
                           const struct ground *ground,
                           enum manner manner, uint32_t begin,
                           uint32_t end, struct answers *found)
{
    uint32_t *furthest = found->furthest;
    double *furthest2 = found->furthest2;
    for (uint32_t s = begin, k = 0; s < end; s = begin + k) {
        if (manner == TOGETHER &&
            stand_together(ground->sorted, s, end)) {
            seek_for(geometry, ABREAST, ground, s, furthest + k,
                     furthest2 + k);
            k += ABREAST;
        } else {
            seek_for(geometry, 1, ground, s, furthest + k,
                     furthest2 + k);
            k++;
        }
    }
}
//<

//> Seek by all threads
static void take_turn(const struct ground *ground, enum manner manner,
                      uint32_t begin, uint32_t end,
                      struct answers *found)
{
    if (ground->space.geometry == STANDARD)
        seek_for_some(STANDARD, ground, manner, begin, end, found);
    else
        seek_for_some(WRAPAROUND, ground, manner, begin, end, found);
}

// In turns, whose answers go back as the points came.
void search_furthest_cells(const struct question *question,
                           const struct carried *carried,
                           enum manner manner, struct answers *answers)
{
    enum { TURN = 1024 };
    const uint32_t n = question->points.n, turns = (n - 1) / TURN + 1;
    struct rows rows = rows_find(&carried->sorted);
    const struct ground ground = {&carried->sorted, &rows,
                                  question->space};
    struct findings findings = findings_for(
        &(struct answers){.furthest = answers->furthest}, n);
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic)
    for (uint32_t turn = 0; turn < turns; turn++) {
        uint32_t furthest[TURN];
        double furthest2[TURN];
        struct answers found = {.furthest = furthest,
                                .furthest2 = furthest2};
        uint32_t begin = turn * TURN, left = n - begin;
        uint32_t end = begin + (left < TURN ? left : TURN);
        take_turn(&ground, manner, begin, end, &found);
        findings_pack(carried, begin, end, &found, &findings);
    }
    findings_send_back(carried, &findings, question->threads, answers);
    findings_free(&findings);
    rows_free(&rows);
}

void furthest_cells(const struct question *question,
                    struct answers *answers)
{
    struct carried carried =
        carry_points(question, POINTS_PER_FAR_CELL);
    answers->built_ns = clock_ns();
    search_furthest_cells(question, &carried, TOGETHER, answers);
    carried_free(&carried);
}
//<
//<
