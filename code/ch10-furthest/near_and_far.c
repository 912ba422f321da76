//> Search near and far
// See near_and_far.h.
#include "ch10-furthest/near_and_far.h"
#include "ch09-row-spans/carry.h"
#include "ch09-row-spans/row_spans.h"
#include "ch10-furthest/far_tiles.h"
#include "ch10-furthest/regions.h"
#include "ch10-furthest/rim.h"
#include "common/clock.h"

#ifdef COUNTING
#define search_row_spans counting_search_row_spans
#endif

//> Find the furthest among few corners
static void furthest_among(const struct question *question,
                           struct corners corners,
                           struct answers *answers)
{
    struct regions regions = regions_make(&corners, question->points.n);
    search_regions(question, &corners, &regions, answers);
    regions_free(&regions);
    corners_free(&corners);
}
//<

//> Sort once for both
// Whoever looks far, too, likes a cell a little fuller.
static const double per_cell = 2;

static void search_near_and_far(const struct question *question,
                                const struct carried *carried,
                                struct answers *answers)
{
    if (answers->furthest && question->space.geometry == WRAPAROUND) {
        search_far_tiles(question, carried, answers);
        return;
    }
    if (answers->nearest)
        search_row_spans(question, carried, TOGETHER, answers);
    if (answers->furthest)
        furthest_among(question,
                       corners_on_rim(question, &carried->sorted),
                       answers);
}

void near_and_far(const struct question *question,
                  struct answers *answers)
{
    if (!answers->nearest && question->space.geometry == STANDARD) {
        furthest_among(question, corners_find(question), answers);
        return;
    }
    struct carried carried = carry_points(question, per_cell);
    answers->built_ns = clock_ns();
    search_near_and_far(question, &carried, answers);
    carried_free(&carried);
}
//<
//<
