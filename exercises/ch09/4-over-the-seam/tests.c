// Tests of the spans of a block: every place in it once, no other, and
// no span more than there must be.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>
#include <string.h>

enum { MOST_POINTS = 200 };

static struct grid grid;
static uint32_t points, *cell_of_place;
static uint32_t column, row, reach; // of the block

// ---- what is given -------------------------------------------------

uint32_t stretches(uint32_t at, uint32_t reach, uint32_t count,
                   struct stretch *to)
{
    if (reach >= count / 2) {
        to[0] = (struct stretch){0, count - 1};
        return 1;
    }
    if (at < reach) {
        to[0] = (struct stretch){0, at + reach};
        to[1] = (struct stretch){at + count - reach, count - 1};
        return 2;
    }
    if (at + reach >= count) {
        to[0] = (struct stretch){0, at + reach - count};
        to[1] = (struct stretch){at - reach, count - 1};
        return 2;
    }
    to[0] = (struct stretch){at - reach, at + reach};
    return 1;
}

// ---- grids and blocks ----------------------------------------------

static uint32_t cells(void)
{
    return grid.columns * grid.rows;
}

// A grid of cells with fewest to most points.
static void lay(uint32_t columns, uint32_t rows, uint32_t fewest,
                uint32_t most, uint64_t seed)
{
    struct random random = {seed};
    uint32_t *start =
        kit_input("start", (size_t)columns * rows + 1, sizeof *start);
    grid = (struct grid){columns, rows, start};
    points = 0;
    for (uint32_t k = 0; k < cells(); k++) {
        start[k] = points;
        points += fewest + random_bits(&random) % (most - fewest + 1);
    }
    start[cells()] = points;
    cell_of_place =
        kit_input("cells of places", points, sizeof *cell_of_place);
    for (uint32_t k = 0; k < cells(); k++)
        for (uint32_t p = start[k]; p < start[k + 1]; p++)
            cell_of_place[p] = k;
}

static uint32_t steps_between(uint32_t a, uint32_t b, uint32_t count)
{
    uint32_t on = a < b ? b - a : a - b;
    return on < count - on ? on : count - on;
}

static bool in_block(uint32_t cell)
{
    return steps_between(column, cell % grid.columns, grid.columns) <=
               reach &&
           steps_between(row, cell / grid.columns, grid.rows) <= reach;
}

// Where the block's points are, in the fewest spans.
static uint32_t right_spans(struct span *spans)
{
    uint32_t n = 0;
    for (uint32_t p = 0; p < points; p++) {
        if (!in_block(cell_of_place[p]))
            continue;
        if (n > 0 && spans[n - 1].end == p)
            spans[n - 1].end = p + 1;
        else
            spans[n++] = (struct span){p, p + 1};
    }
    return n;
}

// ---- what was found ------------------------------------------------

static struct span *spans; // of this block
static uint32_t *found;    // how many

static const char *tell_block(void)
{
    return kit_text("home in column %u, row %u of %u by %u, reach %u",
                    column, row, grid.columns, grid.rows, reach);
}

static const char *tell_place(uint32_t place)
{
    uint32_t cell = cell_of_place[place];
    return kit_text("place %u, which is in column %u, row %u", place,
                    cell % grid.columns, cell / grid.columns);
}

static const char *tell_spans(const struct span *of, uint32_t n)
{
    const char *text = kit_text("%u", n);
    for (uint32_t s = 0; s < n && s < 6; s++)
        text = kit_text("%s%s %u to %u", text, s ? "," : ":",
                        of[s].begin, of[s].end);
    return n > 6 ? kit_text("%s, ...", text) : text;
}

static const char *missing_cause(uint32_t place)
{
    uint32_t cell = cell_of_place[place];
    if (abs((int)(cell % grid.columns) - (int)column) > (int)reach)
        return "It is beyond the seam: the last column is beside the "
               "first one of the same row, though in memory the next "
               "row follows.";
    if (abs((int)(cell / grid.columns) - (int)row) > (int)reach)
        return "It is beyond the seam: the last row is beside the "
               "first.";
    return "A block has all cells from its first column to its last, "
           "in each of its rows. Their places end where the next "
           "cell's begin.";
}

static void check_places(void)
{
    static uint8_t covered[MOST_POINTS];
    memset(covered, 0, sizeof covered);
    for (uint32_t s = 0; s < *found; s++) {
        if (spans[s].begin > spans[s].end || spans[s].end > points)
            WRONG(.where = tell_block(),
                  .expected =
                      kit_text("spans of the %u places", points),
                  .found = tell_spans(spans, *found),
                  .cause = "A span begins before it ends. Have all "
                           "that you return been written?");
        for (uint32_t p = spans[s].begin; p < spans[s].end; p++)
            covered[p] += covered[p] < 2;
    }
    for (uint32_t p = 0; p < points; p++) {
        bool wanted = in_block(cell_of_place[p]);
        if (wanted && covered[p] == 0)
            WRONG(.where = tell_block(), .expected = tell_place(p),
                  .found = "it is in no span",
                  .cause = missing_cause(p));
        if (!wanted && covered[p] > 0)
            WRONG(.where = tell_block(),
                  .expected = "no place outside the block",
                  .found = tell_place(p),
                  .cause = "A stretch of columns ends where the first "
                           "cell behind it begins.");
        if (covered[p] > 1)
            WRONG(.where = tell_block(), .expected = "every place once",
                  .found =
                      kit_text("%s, is in two spans", tell_place(p)),
                  .cause = "The way to both sides leads to the same "
                           "cell, if the block is as large as the "
                           "grid.");
    }
}

static const char *too_many_cause(void)
{
    for (uint32_t s = 0; s < *found; s++)
        if (spans[s].begin == spans[s].end)
            return "Where there are no points there need not be a "
                   "span.";
    for (uint32_t s = 1; s < *found; s++)
        if (spans[s].begin < spans[s - 1].end)
            return "They are not in ascending order: what lies beyond "
                   "the seam may come first in memory.";
    for (uint32_t s = 1; s < *found; s++) {
        uint32_t place = spans[s].begin;
        if (spans[s - 1].end != place)
            continue;
        if (cell_of_place[place] / grid.columns !=
            cell_of_place[place - 1] / grid.columns)
            return kit_text("One span ends and the next begins at "
                            "place %u. The last cell "
                            "of a row is followed in memory by the "
                            "first of the next: make one of them.",
                            place);
        return kit_text(
            "Two spans of a row touch at place %u: make one "
            "of them.",
            place);
    }
    return "Is each of them written once?";
}

static void check_fewest(void)
{
    static struct span right[MOST_POINTS];
    uint32_t n = right_spans(right);
    if (*found != n || memcmp(right, spans, n * sizeof *right) != 0)
        WRONG(.where = tell_block(), .expected = tell_spans(right, n),
              .found = tell_spans(spans, *found),
              .cause = too_many_cause());
}

// ---- all blocks of a reach -----------------------------------------

static uint32_t room; // for the spans of a block

// All homes that are at least so many columns and rows from the edges,
// one after another.
static struct margin {
    uint32_t columns, rows;
} margin;

static void first_home(void)
{
    column = margin.columns;
    row = margin.rows;
}

static bool next_home(void)
{
    if (++column + margin.columns < grid.columns)
        return true;
    column = margin.columns;
    return ++row + margin.rows < grid.rows;
}

static void ask_for_all(void)
{
    first_home();
    do {
        *found++ =
            STUDENT(block_spans)(&grid, column, row, reach, spans);
        spans += room;
    } while (next_home());
}

static void check_room(void)
{
    if (*found > room)
        WRONG(.where = tell_block(),
              .expected = kit_text("at most %u spans", room),
              .found = kit_text("%u", *found),
              .cause = "Each row of the block is one span, or two.");
}

static void check_all(uint32_t r, struct margin m, bool fewest)
{
    reach = r;
    margin = m;
    room = 2 * (r < grid.rows / 2 ? 2 * r + 1 : grid.rows);
    uint32_t homes =
        (grid.columns - 2 * m.columns) * (grid.rows - 2 * m.rows);
    spans = kit_output("spans", (size_t)homes * room, sizeof *spans);
    found = kit_output("how many", homes, sizeof *found);
    CALL(ask_for_all());
    first_home();
    do {
        check_room();
        check_places();
        if (fewest)
            check_fewest();
        spans += room;
        found++;
    } while (next_home());
}

// ---- tests ---------------------------------------------------------

static const struct margin none;

static void inside(uint64_t seed)
{
    lay(8, 7, 1, 3, seed);
    check_all(1, (struct margin){2, 1}, true);
    kit_next_case();
    lay(8, 7, 0, 2, seed);
    check_all(2, (struct margin){2, 2}, false);
}

static void seam(uint64_t seed)
{
    lay(6, 5, 1, 2, seed);
    check_all(1, (struct margin){0, 2}, false);
    check_all(1, (struct margin){2, 0}, false);
    check_all(1, none, false);
    kit_next_case();
    lay(7, 6, 0, 1, seed);
    check_all(2, none, false);
}

static void fewest(uint64_t seed)
{
    lay(6, 5, 1, 2, seed);
    check_all(1, none, true);
    kit_next_case();
    lay(7, 6, 0, 1, seed);
    check_all(2, none, true);
    kit_next_case();
    lay(9, 9, 0, 1, seed);
    check_all(3, none, true);
}

static void small(uint64_t seed)
{
    static const uint32_t reaches[] = {0, 1, 2, 3, 0x80000000};
    lay(4, 4, 1, 2, seed);
    check_all(2, none, true);
    kit_next_case();
    for (uint32_t k = 0; k < 16; k++)
        for (int r = 0; r < 5; r++) {
            lay(1 + k % 4, 1 + k / 4, 0, 2, seed);
            check_all(reaches[r], none, true);
            kit_next_case();
        }
}

const struct kit_test kit_tests[] = {
    {"inside", 1, "blocks that touch no edge", inside},
    {"seam", 2, "blocks that go across the edges", seam},
    {"fewest", 4, "no span more than necessary", fewest},
    {"small", 3, "grids hardly larger than a block, or smaller", small},
    {0},
};
