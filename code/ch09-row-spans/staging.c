//> Stage three row spans
// Chooses the columns around the queries, an origin in the middle of
// them, and has the kernel copy. Refuses where single precision could
// not certify anything; a refusal costs a few look-ups.
#include "ch09-row-spans/staging.h"
#include "ch09-row-spans/span_kernels.h"
#include <stddef.h>

//> Prepare a staging buffer
void staging_prepare(struct staging *staging, double max_reach)
{
    staging->max_reach = max_reach;
    for (uint32_t k = 0; k < PLACES; k++)
        staging->place[k] = k;
}
//<

//> Choose the columns
// One more on each side of the queries' own. With wraparound these may
// be beyond the seam, as long as no column is seen on both sides.
static bool choose_columns(const struct scene *scene, uint32_t from,
                           uint32_t to, struct staging *staging)
{
    const int64_t count = scene->sorted->grid.x.count;
    const bool wraps = scene->space.geometry == WRAPAROUND;
    staging->first = (int64_t)from - (wraps || from > 0);
    staging->last = (int64_t)to + (wraps || to + 1 < count);
    staging->seam = INT64_MAX; // none
    staging->fold[0] = staging->fold[1] = 0;
    //> Find the seam
    if (staging->first < 0) {
        staging->seam = 0;
        staging->fold[0] = count;
    } else if (staging->last == count) {
        staging->seam = count;
        staging->fold[1] = -count;
    }
    //<
    return !wraps || (staging->last - staging->first + 1 < count &&
                      scene->sorted->grid.y.count > ROWS);
}
//<

//> Find where a folded column begins
// Where a cell begins, also one period back or on.
static double begin_of_cell(const struct axis *axis, int64_t k)
{
    const int64_t count = axis->count;
    if (k < 0)
        return axis->border[k + count] - axis->period;
    if (k > count)
        return axis->border[k - count] + axis->period;
    return axis->border[k];
}
//<

//> Tell whether a seam is fine enough
// The origin as seen from beyond the seam is rounded, as coarsely as
// doubles of its size are. It must be finer than single precision.
static bool seam_is_fine(const struct axis *axis, double origin,
                         double reach)
{
    return fabs(origin) + axis->period <= reach * 0x1p22;
}
//<

//> Choose the origin
static bool choose_origin(const struct scene *scene, uint32_t row,
                          struct staging *staging)
{
    const struct axis *x = &scene->sorted->grid.x;
    const struct axis *y = &scene->sorted->grid.y;
    const bool wraps = scene->space.geometry == WRAPAROUND;
    const double left = begin_of_cell(x, staging->first);
    const double right = begin_of_cell(x, staging->last + 1);
    const double low =
        begin_of_cell(y, (int64_t)row - (wraps || row > 0));
    const double high = begin_of_cell(
        y, (int64_t)row + 1 + (wraps || row + 1 < y->count));
    staging->x = left / 2 + right / 2;
    staging->y = low / 2 + high / 2;
    staging->reach = MAX(MAX(staging->x - left, right - staging->x),
                         MAX(staging->y - low, high - staging->y));
    //> Refuse a seam that is too coarse
    if (staging->seam != INT64_MAX &&
        !seam_is_fine(x, staging->x, staging->reach))
        return false;
    const bool over = row == 0 || row + 1 == y->count;
    if (wraps && over && !seam_is_fine(y, staging->y, staging->reach))
        return false;
    //<
    return staging->reach > MIN_REACH && staging->reach < MAX_REACH;
}
//<

//> Hold the parts of a row
// From left to right. Without a seam in the row the second is empty.
struct parts {
    struct span_source part[2];
};
//<

//> Move the origin over the seam
// What lies one period back is measured from an origin one period on.
static double seen_from(double origin, double period, int64_t fold)
{
    return fold > 0   ? origin + period
           : fold < 0 ? origin - period
                      : origin;
}
//<

//> Find the parts of a row
// The row k of the buffer: the grid's row - 1, row or row + 1.
static struct parts find_parts(const struct scene *scene, uint32_t row,
                               uint32_t k, struct staging *staging)
{
    const struct grid *grid = &scene->sorted->grid;
    const int64_t count = grid->y.count, r = (int64_t)row + k - 1;
    const int64_t fold = r < 0 ? count : r < count ? 0 : -count;
    const int64_t end = staging->last + 1;
    struct parts parts = {0};
    staging->row[k].start = NULL;
    if (fold != 0 && scene->space.geometry == STANDARD)
        return parts;
    const uint32_t *start =
        scene->sorted->cells.start + (r + fold) * grid->x.count;
    const double y = seen_from(staging->y, grid->y.period, fold);
    //> Look both parts up
    for (int p = 0; p < 2; p++) {
        int64_t from = p == 0 ? staging->first : staging->seam;
        int64_t to =
            p == 0 && staging->seam < end ? staging->seam : end;
        if (from < to)
            parts.part[p] = (struct span_source){
                start[from + staging->fold[p]],
                start[to + staging->fold[p]],
                seen_from(staging->x, grid->x.period, staging->fold[p]),
                y};
    }
    //<
    staging->row[k].start = start;
    return parts;
}
//<

//> Fill places with far points
// A lane without a query may name what is at FAR: that has an index,
// too, if not its own.
static void fill_far(struct staging *staging, uint32_t place,
                     uint32_t count)
{
    for (uint32_t k = place; k < place + count; k++) {
        staging->place_x[k] = staging->place_y[k] = FAR;
        staging->index[k] = 0;
    }
}
//<

//> Stage a row
// Says whether the row has room for them. Kernels write up to PAD
// places too many, over which a pad of FAR is written.
static bool stage_row(const struct scene *scene,
                      const struct parts *parts, uint32_t k,
                      struct staging *staging)
{
    const struct span_source *part = parts->part;
    const uint32_t first = part[0].end - part[0].begin;
    const uint32_t second = part[1].end - part[1].begin;
    uint32_t place = k * STAGED + PAD;
    if (first > STAGED - 2 * PAD || second > STAGED - 2 * PAD - first)
        return false;
    fill_far(staging, k * STAGED, PAD);
    staging->row[k].shift[0] = place - part[0].begin;
    scene->kernels->stage(scene->sorted, &part[0], place, staging);
    place += first;
    staging->row[k].shift[1] = place - part[1].begin;
    if (second > 0)
        scene->kernels->stage(scene->sorted, &part[1], place, staging);
    fill_far(staging, place + second, PAD);
    return true;
}
//<

//> Stage the candidates of some queries
bool stage_candidates(const struct scene *scene, uint32_t row,
                      uint32_t begin, uint32_t width,
                      struct staging *staging)
{
    const struct sorted *sorted = scene->sorted;
    const struct axis *across = &sorted->grid.x;
    const double *x = sorted->points.x + begin;
    if (!choose_columns(scene, axis_cell(across, x[0]),
                        axis_cell(across, x[width - 1]), staging) ||
        !choose_origin(scene, row, staging) ||
        (width > BATCH && staging->reach > staging->max_reach))
        return false;
    for (uint32_t k = 0; k < ROWS; k++) {
        struct parts parts = find_parts(scene, row, k, staging);
        if (!stage_row(scene, &parts, k, staging))
            return false;
    }
    return true;
}
//<

//> Find the place of a column
// Where the points of a column begin.
static uint32_t place_at(const struct staging *staging,
                         const struct staged_row *row, int64_t column)
{
    int part = column > staging->seam;
    return row->start[column + staging->fold[part]] + row->shift[part];
}
//<

//> Find the candidates of a batch
void find_candidates(const struct scene *scene,
                     const struct staging *staging,
                     struct query_batch *batch)
{
    const struct axis *across = &scene->sorted->grid.x;
    const double *x = scene->sorted->points.x + batch->begin;
    const uint32_t from = axis_cell(across, x[0]);
    const uint32_t to = axis_cell(across, x[batch->width - 1]);
    const int64_t left = (int64_t)from - 1, right = (int64_t)to + 1;
    const int64_t first = left > staging->first ? left : staging->first;
    const int64_t end =
        (right < staging->last ? right : staging->last) + 1;
    batch->block.x = axis_range(across, from, to, 1);
    batch->own =
        batch->begin + staging->row[1].shift[staging->first < 0];
    //> Find three spans
    for (uint32_t k = 0; k < ROWS; k++) {
        const struct staged_row *row = &staging->row[k];
        batch->from[k] = batch->to[k] = k * STAGED + PAD;
        if (row->start) {
            batch->from[k] = place_at(staging, row, first);
            batch->to[k] = place_at(staging, row, end);
        }
    }
    //<
}
//<
//<
