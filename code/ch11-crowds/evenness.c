//> Choose by a sample
// A large sample finds small crowds: one of 256 points is drawn, some
// thousand at least.
#include "ch11-crowds/evenness.h"
#include "ch04-cell-sort/grid.h"
#include "ch10-furthest/near_and_far.h"
#include "ch11-crowds/adaptive.h"
#include "common/min_max.h"
#include "common/random.h"
#include <string.h>

enum { ONE_OF = 256, SMALLEST_SAMPLE = 2048, PER_COARSE_CELL = 8 };

//> Measure evenness
struct evenness measure_evenness(const struct question *question,
                                 struct workspace *workspace)
{
    const struct points p = question->points;
    const uint32_t sample =
        MAX(p.n / ONE_OF, MIN(p.n, SMALLEST_SAMPLE));
    struct mark mark = workspace_mark(workspace);
    const struct grid grid = grid_fit_in(
        workspace, question, (double)PER_COARSE_CELL * p.n / sample);
    const uint32_t m = grid_cells(&grid);
    uint32_t *count = workspace_take(workspace, m, sizeof *count);
    struct random random = {p.n};
    struct evenness evenness = {.sample = sample, .cells = m};
    memset(count, 0, m * sizeof *count);
    for (uint32_t k = 0; k < sample; k++) {
        const uint32_t i = random_bits(&random) % p.n;
        count[grid_cell(&grid, p.x[i], p.y[i])]++;
    }
    for (uint32_t cell = 0; cell < m; cell++) {
        evenness.together += (double)count[cell] * count[cell] / sample;
        evenness.most = MAX(evenness.most, count[cell]);
    }
    evenness.expected = 1 + (double)(sample - 1) / m;
    workspace_release(workspace, mark);
    return evenness;
}
//<

//> Decide whether a single grid will do
// A box without width is not cut into cells: all is in one.
bool is_even(const struct evenness *evenness)
{
    return evenness->cells >= evenness->sample / 16 &&
           evenness->together < 1.5 * evenness->expected &&
           evenness->most < 5 * evenness->expected;
}
//<

//> Choose between grid and pieces
static void choose_and_search(const struct question *question,
                              struct answers *answers)
{
    struct extent box[2];
    struct question known = *question;
    box_of_points(question, &box[0], &box[1]);
    known.box = box;
    const struct evenness evenness =
        measure_evenness(&known, question->workspace);
    const bool even = is_even(&evenness);
    if (question->by)
        *question->by = even ? "near-and-far" : "adaptive";
    if (even)
        near_and_far(&known, answers);
    else
        adaptive(question, answers);
}

void by_sample(const struct question *question, struct answers *answers)
{
    search_in_workspace(question, choose_and_search, answers);
}
//<
//<
