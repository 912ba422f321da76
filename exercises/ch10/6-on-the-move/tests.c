// Tests of points that move: answers after every step, and how often
// points are put into a cell.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>

enum { STEPS = 12, MOST = 800, MOST_CELLS = 1024 };

static struct box box;
static struct points step[STEPS];
static uint32_t asking; // after how many steps

// The lists, of which only the student's process has its own.
static struct {
    uint32_t first[MOST_CELLS], next[MOST], cell[MOST];
} lists;

// What the student's process leaves behind: the answers, and where
// each point was kept, after each step.
static struct notes {
    uint64_t puts[STEPS], measured;
    bool no_point, no_cell, endless;
} * notes;
static uint32_t *found, *kept;

static void need_point(uint32_t i)
{
    if (i < step[0].n)
        return;
    notes->no_point = true;
    kit_leave();
}

static void need_cell(uint32_t cell)
{
    if (cell < box.columns * box.rows)
        return;
    notes->no_cell = true;
    kit_leave();
}

uint32_t kept_in(uint32_t i)
{
    need_point(i);
    return lists.cell[i];
}

uint32_t first_in(uint32_t cell)
{
    need_cell(cell);
    return lists.first[cell];
}

uint32_t next_to(uint32_t i)
{
    need_point(i);
    return lists.next[i];
}

void put(uint32_t i, uint32_t cell)
{
    need_point(i);
    need_cell(cell);
    notes->puts[asking]++;
    if (lists.cell[i] != NONE) {
        uint32_t *from = &lists.first[lists.cell[i]];
        while (*from != i)
            from = &lists.next[*from];
        *from = lists.next[i];
    }
    lists.cell[i] = cell;
    lists.next[i] = lists.first[cell];
    lists.first[cell] = i;
}

static double between(struct points points, uint32_t i, uint32_t j)
{
    double dx = points.x[j] - points.x[i];
    double dy = points.y[j] - points.y[i];
    return dx * dx + dy * dy;
}

double measure(struct points points, uint32_t i, uint32_t j)
{
    need_point(i);
    need_point(j);
    if (++notes->measured > (uint64_t)STEPS * MOST * MOST * 4) {
        notes->endless = true;
        kit_leave();
    }
    return between(points, i, j);
}

// ---- motions -------------------------------------------------------

static void begin(uint32_t n, uint32_t columns, uint32_t rows)
{
    kit_next_case();
    box = (struct box){columns, rows};
    for (int t = 0; t < STEPS; t++)
        step[t] = (struct points){n, kit_input("x", n, sizeof(double)),
                                  kit_input("y", n, sizeof(double))};
}

// A place in [0, size), on multiples of 1 / fine.
static double place(struct random *random, uint32_t size, uint32_t fine)
{
    return (double)(random_bits(random) % ((uint64_t)size * fine)) /
           fine;
}

// From the edge of the box back into it.
static double inside(double x, uint32_t size)
{
    double last = size - 0x1p-16;
    x = fabs(x);
    return x > last ? 2 * last - x : x;
}

// Each point goes straight on, by at most a quarter of a cell in a
// step, and one in a hundred jumps.
static void drift(uint32_t n, uint32_t columns, uint32_t rows,
                  uint32_t fine, bool jumps, uint64_t seed)
{
    struct random random = {seed};
    begin(n, columns, rows);
    for (uint32_t i = 0; i < n; i++) {
        double x = place(&random, columns, fine), dx;
        double y = place(&random, rows, fine), dy;
        dx = floor((random_uniform(&random) - 0.5) * fine / 2) / fine;
        dy = floor((random_uniform(&random) - 0.5) * fine / 2) / fine;
        for (int t = 0; t < STEPS; t++) {
            step[t].x[i] = x;
            step[t].y[i] = y;
            x = inside(x + dx, columns);
            y = inside(y + dy, rows);
            if (jumps && random_bits(&random) % 100 == 0) {
                x = place(&random, columns, fine);
                y = place(&random, rows, fine);
            }
        }
    }
    kit_given("%u points that move in %u by %u cells", n, columns,
              rows);
}

// Each point trembles, by a sixteenth to each side, most around a place
// on a border, or near it.
static void tremble(uint32_t n, uint32_t columns, uint32_t rows,
                    uint64_t seed)
{
    struct random random = {seed};
    begin(n, columns, rows);
    for (uint32_t i = 0; i < n; i++) {
        double x = 0.0625 + place(&random, columns, 8);
        double y = 0.0625 + place(&random, rows, 8);
        bool at_left = x >= 1 && random_bits(&random) % 3 == 0;
        bool at_foot = y >= 1 && random_bits(&random) % 3 == 0;
        x = at_left ? floor(x) : x;
        y = at_foot ? floor(y) : y;
        const bool far = random_bits(&random) % 3 == 0;
        for (int t = 0; t < STEPS; t++) {
            step[t].x[i] = x + (place(&random, 1, 1 << 16) - 0.5) / 8;
            step[t].y[i] = y + (place(&random, 1, 1 << 16) - 0.5) / 8;
            step[t].x[i] = floor(step[t].x[i] * 0x1p16) / 0x1p16;
            step[t].y[i] = floor(step[t].y[i] * 0x1p16) / 0x1p16;
            if (far && t < 2) { // from end to end, as far as it goes
                const double side = t == 0 ? 0.0625 : -0.0625;
                step[t].x[i] = fmin(x + side, columns - 0x1p-16);
                step[t].y[i] = fmin(y + side, rows - 0x1p-16);
            }
        }
    }
    kit_given("%u points that tremble in %u by %u cells", n, columns,
              rows);
}

// ---- answers -------------------------------------------------------

static void run(uint32_t steps)
{
    uint32_t n = step[0].n;
    for (uint32_t cell = 0; cell < MOST_CELLS; cell++)
        lists.first[cell] = NONE;
    for (uint32_t i = 0; i < n; i++)
        lists.cell[i] = lists.next[i] = NONE;
    for (asking = 0; asking < steps; asking++) {
        STUDENT(keep_up)(step[asking], box);
        for (uint32_t i = 0; i < n; i++)
            kept[asking * n + i] = lists.cell[i];
        for (uint32_t i = 0; i < n; i++)
            found[asking * n + i] =
                STUDENT(nearest_now)(step[asking], box, i);
    }
}

static uint32_t right_answer(struct points points, uint32_t i)
{
    uint32_t best = i == 0 ? 1 : 0;
    for (uint32_t j = best + 1; j < points.n; j++)
        if (j != i && between(points, i, j) < between(points, i, best))
            best = j;
    return best;
}

static uint32_t cell_at(struct points points, uint32_t i)
{
    return (uint32_t)points.y[i] * box.columns + (uint32_t)points.x[i];
}

// By how much a point is outside of a cell.
static double stray(struct points points, uint32_t i, uint32_t cell)
{
    double x = points.x[i] - cell % box.columns;
    double y = points.y[i] - cell / box.columns;
    return fmax(fmax(-x, x - 1), fmax(fmax(-y, y - 1), 0));
}

static const char *tell(struct points points, uint32_t i, uint32_t t)
{
    uint32_t cell = i < points.n ? kept[t * points.n + i] : NONE;
    if (cell == NONE)
        return kit_point(points, i);
    return kit_text("%s, kept in column %u, row %u",
                    kit_point(points, i), cell % box.columns,
                    cell / box.columns);
}

static const char *left_long_ago(void)
{
    uint32_t n = step[0].n;
    for (uint32_t t = 0; t < asking; t++)
        for (uint32_t i = 0; i < n; i++) {
            uint32_t cell = kept[t * n + i];
            if (cell != NONE && stray(step[t], i, cell) > 1)
                return kit_text("Points are still kept in cells that "
                                "they have left long ago: at step %u, "
                                "%s.",
                                t, tell(step[t], i, t));
        }
    return NULL;
}

static const char *wrong_cause(uint32_t t, uint32_t i, uint32_t right)
{
    struct points points = step[t];
    uint32_t answer = found[t * points.n + i];
    uint32_t cell = kept[t * points.n + right];
    if (answer == i)
        return "A point is not its own neighbor.";
    if (answer >= points.n)
        return "No point was found. If a block holds no other, look "
               "further.";
    if (between(points, i, answer) == between(points, i, right))
        return "These tie: the lowest index is asked for, and lists "
               "are in no order. A cell may have to be searched though "
               "no point in it can be nearer.";
    if (cell == NONE)
        return "The right one was never put into a cell.";
    const char *left = left_long_ago();
    if (left)
        return left;
    if (stray(points, right, cell) > 0 ||
        stray(points, i, kept[t * points.n + i]) > 0)
        return "Where points are kept in cells that they have left, "
               "one from beyond the block may be nearer than its "
               "border, by as much as points may stray. If not even "
               "that is left, nothing is certain.";
    return "It lies beyond the cells that were searched. A block is "
           "large enough only if the best distance is less than that "
           "of its border: is either of them squared?";
}

static void check_answers(uint32_t steps)
{
    uint32_t n = step[0].n;
    notes = kit_output("the counts", 1, sizeof *notes);
    found = kit_output("the answers", (size_t)n * STEPS, sizeof *found);
    kept = kit_output("kept", (size_t)n * STEPS, sizeof *kept);
    *notes = (struct notes){0};
    CALL(run(steps));
    asking = steps;
    if (notes->no_point || notes->no_cell)
        WRONG(.expected = "points and cells of the box",
              .found = notes->no_point
                           ? "a function called for no point"
                           : "a function called for no cell",
              .cause =
                  notes->no_point
                      ? "A list ends with NONE, and may be empty."
                      : "Along the edges of the box a block has "
                        "fewer cells. And a point that was never put "
                        "is kept in NONE.");
    if (notes->endless)
        WRONG(.expected = "an end",
              .found = kit_text("more than %ju distances",
                                (uintmax_t)notes->measured),
              .cause = "When does the search stop if nothing is "
                       "near enough?");
    for (uint32_t t = 0; t < steps; t++)
        for (uint32_t i = 0; i < n; i++) {
            uint32_t right = right_answer(step[t], i);
            if (found[t * n + i] == right)
                continue;
            WRONG(.where =
                      kit_text("step %u, %s", t, tell(step[t], i, t)),
                  .expected = tell(step[t], right, t),
                  .found = tell(step[t], found[t * n + i], t),
                  .picture = {step[t],
                              {i, found[t * n + i]},
                              {i, right}},
                  .cause = wrong_cause(t, i, right));
        }
}

// ---- counts --------------------------------------------------------

static void check_puts(bool trembling)
{
    uint32_t n = step[0].n;
    check_answers(STEPS);
    uint64_t enough = n, count = 0;
    for (uint32_t t = 0; t < STEPS; t++) {
        for (uint32_t i = 0; t > 0 && !trembling && i < n; i++)
            enough += cell_at(step[t], i) != cell_at(step[t - 1], i);
        count += notes->puts[t];
        if (count <= enough)
            continue;
        WRONG(.where = kit_text("up to step %u", t),
              .expected = kit_text("at most %ju points put into cells",
                                   (uintmax_t)enough),
              .found = kit_text("%ju", (uintmax_t)count),
              .cause =
                  2 * notes->puts[t] >= n
                      ? "All points are put anew. Most are still "
                        "where they were: look before you put."
                  : trembling
                      ? "What trembles on a border must not be put to "
                        "and fro. Let points stray a little from the "
                        "cells that they are kept in."
                      : "More are put than go from one cell to "
                        "another.");
    }
}

static void check_distances(void)
{
    check_answers(STEPS);
    uint64_t puts = 0;
    for (uint32_t t = 1; t < STEPS; t++)
        puts += notes->puts[t];
    if (2 * puts >= (uint64_t)(STEPS - 1) * step[0].n)
        WRONG(.expected = "few distances, though points stay in cells "
                          "that they have left",
              .found = kit_text("%.2f of all points put at each step",
                                (double)puts / (STEPS - 1) / step[0].n),
              .cause = "All points are put anew, or nearly so. It is "
                       "the margin that makes few distances an art.");
    double mean = (double)notes->measured / STEPS / step[0].n;
    if (mean > 24 || mean == 0)
        WRONG(.expected = "at most 24 distances on average",
              .found = kit_text("%.1f", mean),
              .cause = mean == 0 ? "Only measure() may tell a distance."
                                 : "A wide margin has the search go on "
                                   "for longer. Besides, no point need "
                                   "be measured twice.");
}

// ---- tests ---------------------------------------------------------

static void still(uint64_t seed)
{
    drift(500, 16, 16, 1 << 16, false, seed);
    check_answers(1);
    drift(200, 10, 13, 2, false, seed);
    check_answers(1);
    for (uint64_t k = 0; k < 20; k++) {
        drift(2 + k, 1 + k % 5 * 3, 1 + k % 4 * 5, 1 << k % 17, false,
              seed + k);
        check_answers(1);
    }
}

static void drifting(uint64_t seed)
{
    drift(600, 17, 18, 1 << 16, true, seed);
    check_answers(STEPS);
    drift(300, 20, 7, 16, true, seed);
    check_answers(STEPS);
    drift(800, 20, 20, 8, false, seed);
    check_answers(STEPS);
}

static void trembling(uint64_t seed)
{
    tremble(600, 15, 16, seed);
    check_answers(STEPS);
    tremble(150, 12, 25, seed);
    check_answers(STEPS);
}

static void few_puts(uint64_t seed)
{
    drift(600, 17, 18, 1 << 16, false, seed);
    check_puts(false);
}

static void no_puts(uint64_t seed)
{
    tremble(600, 15, 16, seed);
    check_puts(true);
}

static void distances(uint64_t seed)
{
    drift(800, 20, 20, 1 << 16, false, seed);
    check_distances();
}

const struct kit_test kit_tests[] = {
    {"still", 1, "right at the first step", still},
    {"drifting", 2, "right while points move", drifting},
    {"trembling", 1, "right while points tremble", trembling},
    {"puts", 2, "no more put than change cells", few_puts},
    {"no-puts", 2, "no tremblers put", no_puts},
    {"distances", 2, "few distances, with few put anew", distances},
    {0},
};
