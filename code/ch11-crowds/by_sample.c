//> Choose by a sample
// A single grid compares a point with some nine times the crowding, the
// number of points in the cell of a point, on average. Lonely points,
// which search in larger blocks, are so few that where the crowding is
// bounded a single grid takes n log n steps at worst.
#include "ch11-crowds/by_sample.h"
#include "ch04-cell-sort/grid.h"
#include "ch09-row-spans/row_spans.h"
#include "ch10-furthest/hull_candidates.h"
#include "ch10-furthest/near_and_far.h"
#include "ch11-crowds/adaptive.h"
#include "ch11-crowds/far_search.h"
#include "common/min_max.h"
#include "common/random.h"
#include <string.h>

//> Limit the density
// By how much the points around a point are denser than if all were
// spread evenly, on average, in cells with c points on average.
static double density(uint64_t together, uint32_t n, double c)
{
    return ((double)together / n - 1) / c;
}

static const double MAX_DENSITY = 6;
//<

//> Look at a sample
enum { ONE_OF = 256, SMALLEST_SAMPLE = 2048, PER_COARSE_CELL = 8 };

static double density_of_sample(const struct question *question)
{
    struct workspace *workspace = question->workspace;
    const struct points p = question->points;
    const uint32_t sample =
        MAX(p.n / ONE_OF, MIN(p.n, SMALLEST_SAMPLE));
    struct mark mark = workspace_mark(workspace);
    const struct grid grid = grid_fit_in(
        workspace, question, (double)PER_COARSE_CELL * p.n / sample);
    const uint32_t m = grid_cells(&grid);
    uint32_t *count = workspace_take(workspace, m, sizeof *count);
    struct random random = {p.n};
    uint64_t together = 0;
    memset(count, 0, m * sizeof *count);
    for (uint32_t k = 0; k < sample; k++) {
        const uint32_t i = random_bits(&random) % p.n;
        together += 2 * count[grid_cell(&grid, p.x[i], p.y[i])]++ + 1;
    }
    workspace_release(workspace, mark);
    return density(together, sample, PER_COARSE_CELL);
}

bool sample_is_even(const struct question *question, double max_density)
{
    return density_of_sample(question) <= 2 * max_density;
}
//<

//> Count the points of all cells
double density_of_cells(const struct sorted *sorted, double c)
{
    const uint32_t *start = sorted->cells.start;
    const uint32_t m = grid_cells(&sorted->grid);
    uint64_t together = 0;
    for (uint32_t cell = 0; cell < m; cell++) {
        const uint64_t here = start[cell + 1] - start[cell];
        together += here * here;
    }
    return density(together, sorted->points.n, c);
}

bool cells_are_even(const struct sorted *sorted, double c,
                    double max_density)
{
    return density_of_cells(sorted, c) <= max_density;
}
//<

//> Search a single grid
// Each says whether the points are even enough; if not, nothing is
// answered. What is answered is no longer wanted.
static bool search_plane(const struct question *question,
                         struct answers *wanted)
{
    struct workspace *workspace = question->workspace;
    const double c = POINTS_PER_SPAN_CELL;
    const struct partition partition =
        partition_make(question, c, RESTORE, workspace);
    const struct sorted *sorted = &partition.sorted;
    if (!cells_are_even(sorted, c, MAX_DENSITY))
        return false;
    search_row_spans(question, &partition, workspace, wanted);
    wanted->nearest = NULL;
    // Many corners are left to the pieces.
    if (wanted->furthest &&
        search_few_corners(
            question, sorted->points,
            corners_of_sorted(question, sorted, workspace), wanted))
        wanted->furthest = NULL;
    return true;
}

static bool search_wraparound(const struct question *question,
                              struct answers *wanted)
{
    const struct partition partition =
        partition_for_both(question, wanted);
    if (!cells_are_even(&partition.sorted, PER_CELL_FOR_BOTH,
                        MAX_DENSITY))
        return false;
    search_near_and_far(question, &partition, wanted);
    *wanted = (struct answers){0};
    return true;
}
//<

//> Choose and search
// Looks at a sample, and then at all cells. The furthest alone need no
// cells in the plane, so that there is nothing that could crowd.
static bool search_even(const struct question *question,
                        struct answers *wanted)
{
    if (question->space.geometry == STANDARD && !wanted->nearest) {
        struct corners corners =
            corners_find(question, question->workspace);
        const bool few = search_few_corners(question, question->points,
                                            corners, wanted);
        if (few)
            wanted->furthest = NULL;
        return few;
    }
    if (!sample_is_even(question, MAX_DENSITY))
        return false;
    return question->space.geometry == STANDARD
               ? search_plane(question, wanted)
               : search_wraparound(question, wanted);
}

static void choose_and_search(const struct question *question,
                              struct answers *answers)
{
    struct extent box[2];
    struct question known = *question;
    struct answers wanted = *answers;
    struct mark mark = workspace_mark(question->workspace);
    box_of_points(question, &box[0], &box[1]);
    known.box = box;
    const bool even = search_even(&known, &wanted);
    workspace_release(question->workspace, mark);
    if (wanted.nearest || wanted.furthest)
        adaptive(question, &wanted);
    if (question->algorithm_name)
        *question->algorithm_name = even ? "near-and-far" : "adaptive";
}

void by_sample(const struct question *question, struct answers *answers)
{
    search_in_workspace(question, choose_and_search, answers);
}
//<
//<
