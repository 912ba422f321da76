// Tests of the layers: every cell of a layer, each once, in grids that
// wrap and that do not, from every home; and in a grid too large to be
// gone through cell by cell.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

enum { LAYERS_MOST = 10 };

// How many steps from a to b, the shorter way.
static uint32_t steps(uint32_t a, uint32_t b, uint32_t count,
                      bool wraps)
{
    uint32_t direct = a > b ? a - b : b - a;
    uint32_t around = count - direct;
    return wraps && around < direct ? around : direct;
}

static uint32_t layer_of(const struct grid *grid, struct cell home,
                         struct cell cell)
{
    uint32_t dx =
        steps(home.column, cell.column, grid->columns, grid->wraps);
    uint32_t dy = steps(home.row, cell.row, grid->rows, grid->wraps);
    return dx > dy ? dx : dy;
}

static const char *tell(struct cell cell)
{
    return kit_text("(%u, %u)", cell.column, cell.row);
}

static uint32_t room_for(const struct grid *grid, uint32_t k)
{
    uint64_t ring = k == 0 ? 1 : 8 * (uint64_t)k;
    uint64_t all = (uint64_t)grid->columns * grid->rows;
    return ring < all ? ring : all;
}

// ---- one layer -----------------------------------------------------

static const struct grid *grid;
static struct cell home;
static uint32_t k;

static const char *where(void)
{
    return kit_text("layer %u around (%u, %u), %u by %u cells%s", k,
                    home.column, home.row, grid->columns, grid->rows,
                    grid->wraps ? " that wrap around" : "");
}

static bool is_half_way(struct cell cell)
{
    return grid->wraps &&
           (2 * steps(home.column, cell.column, grid->columns, true) ==
                grid->columns ||
            2 * steps(home.row, cell.row, grid->rows, true) ==
                grid->rows);
}

static void check_cell(const struct cell *cells, uint32_t i)
{
    struct cell cell = cells[i];
    if (cell.column >= grid->columns || cell.row >= grid->rows)
        WRONG(.where = where(), .expected = "cells of the grid",
              .found = tell(cell),
              .cause = grid->wraps
                           ? "Before column 0 comes the last column. "
                             "In unsigned numbers, 0 - 1 is very large."
                           : "The layer sticks out of the grid: what "
                             "is outside is not a cell.");
    if (layer_of(grid, home, cell) != k)
        WRONG(.where = where(), .expected = "its cells only",
              .found = kit_text("%s, which is in layer %u", tell(cell),
                                layer_of(grid, home, cell)),
              .cause = grid->wraps && 2 * k > layer_of(grid, home, cell)
                           ? "The other way round this cell is nearer. "
                             "More than half way round, nothing is new."
                           : "The larger of its two numbers of steps "
                             "makes the layer of a cell.");
    for (uint32_t j = 0; j < i; j++)
        if (cells[j].column == cell.column && cells[j].row == cell.row)
            WRONG(.where = where(), .expected = "every cell once",
                  .found = kit_text("%s twice", tell(cell)),
                  .cause =
                      k == 0 ? "Layer 0 is one cell: its first row is "
                               "also its last."
                      : is_half_way(cell)
                          ? "This cell is just half way round, and has "
                            "been reached from both sides."
                          : "The corners of a layer belong to a row "
                            "and to a column. Only one may take them.");
}

static void check_complete(const struct cell *cells, uint32_t count,
                           struct cell cell)
{
    if (layer_of(grid, home, cell) != k)
        return;
    for (uint32_t i = 0; i < count; i++)
        if (cells[i].column == cell.column && cells[i].row == cell.row)
            return;
    WRONG(.where = where(),
          .expected = kit_text("%s among the cells", tell(cell)),
          .found = kit_text("layer() returned %u cells; %s is missing",
                            count, tell(cell)),
          .cause = is_half_way(cell)
                       ? "This cell is just half way round: it has to "
                         "be taken from one side."
                   : grid->wraps
                       ? "With wraparound there is no edge: this cell "
                         "is reached across it."
                       : "Is the part of each row and of each column "
                         "that is inside the grid complete?");
}

static void check_cells(const struct cell *cells, uint32_t count)
{
    const uint32_t room = room_for(grid, k);
    if (count > room)
        WRONG(.where = where(),
              .expected = kit_text("at most %u cells", room),
              .found = kit_text("%u", count),
              .cause = "The answer is how many cells were written.");
    for (uint32_t i = 0; i < count; i++)
        check_cell(cells, i);
    uint64_t all = (uint64_t)grid->columns * grid->rows;
    for (uint64_t c = 0; all <= 1000 && c < all; c++)
        check_complete(
            cells, count,
            (struct cell){c % grid->columns, c / grid->columns});
}

// The layers from the first to the last, in one call, each with a room
// of its own.
static void check_layers(uint32_t first, uint32_t last)
{
    struct cell *cells[LAYERS_MOST];
    uint32_t *count =
        kit_output("the answer", last - first + 1, sizeof *count);
    for (k = first; k <= last; k++)
        cells[k - first] =
            kit_output("cells", room_for(grid, k), sizeof **cells);
    CALL(for (k = first; k <= last; k++) {
        kit_given("%s", where());
        count[k - first] =
            STUDENT(layer)(grid, home, k, cells[k - first]);
        check_cells(cells[k - first], count[k - first]);
    });
    for (k = first; k <= last; k++) {
        kit_given("%s", where());
        check_cells(cells[k - first], count[k - first]);
    }
    kit_next_case();
}

static void check_all(uint32_t columns, uint32_t rows, bool wraps)
{
    static struct grid every;
    every = (struct grid){columns, rows, wraps};
    grid = &every;
    for (uint32_t c = 0; c<columns; c += columns> 6 ? 3 : 1)
        for (uint32_t r = 0; r<rows; r += rows> 6 ? 3 : 1) {
            home = (struct cell){c, r};
            check_layers(0, columns > rows ? columns : rows);
        }
}

// A layer of few cells takes no time, in a grid of 400 million.
static void check_wide(uint32_t columns, uint32_t rows)
{
    static struct grid wide;
    wide = (struct grid){columns, rows, true};
    grid = &wide;
    home = (struct cell){0, rows - 1};
    check_layers(3, 3);
    const double seconds = kit_seconds(false);
    if (seconds > 0.15)
        WRONG(.expected = "24 cells, without a look at the others",
              .found = kit_text("%.2f seconds of work", seconds),
              .cause = "Do not go through the grid to pick out what "
                       "belongs to the layer: go around home.");
}

// ---- the grids -----------------------------------------------------

static void inside(uint64_t seed)
{
    (void)seed;
    static const struct grid large = {21, 19, false};
    grid = &large;
    home = (struct cell){10, 9};
    check_layers(0, 7);
}

static void edges(uint64_t seed)
{
    (void)seed;
    check_all(7, 5, false);
    check_all(1, 6, false);
    check_all(4, 1, false);
    check_all(1, 1, false);
}

static void across(uint64_t seed)
{
    (void)seed;
    check_all(9, 7, true);
    check_all(5, 5, true);
    check_wide(20001, 20003);
}

static void half_way(uint64_t seed)
{
    (void)seed;
    check_all(6, 6, true);
    check_all(8, 3, true);
    check_all(2, 4, true);
    check_all(1, 2, true);
    check_all(1, 1, true);
    check_wide(20000, 20004);
}

// Too many cells to go through.
static void large(uint64_t seed)
{
    static const struct grid grids[] = {{1000000000, 900000000, false},
                                        {1000000000, 900000000, true}};
    struct random random = {seed};
    check_wide(20000, 20004);
    for (int g = 0; g < 2; g++) {
        grid = &grids[g];
        for (int place = 0; place < 20; place++) {
            home = (struct cell){random_bits(&random) % grid->columns,
                                 random_bits(&random) % grid->rows};
            if (place % 2)
                home.row = grid->rows - 1;
            k = place / 2;
            uint32_t room = room_for(grid, k), expected = room;
            if (!grid->wraps && place % 2)
                expected = k == 0 ? 1 : 4 * k + 1;
            struct cell *cells =
                kit_output("cells", room, sizeof *cells);
            uint32_t *count = kit_output("the answer", 1, 4);
            kit_given("%s", where());
            CALL(*count = STUDENT(layer)(grid, home, k, cells));
            if (*count != expected)
                WRONG(.where = where(),
                      .expected = kit_text("%u cells", expected),
                      .found = kit_text("%u", *count));
            for (uint32_t i = 0; i < *count; i++)
                check_cell(cells, i);
            kit_next_case();
        }
    }
}

const struct kit_test kit_tests[] = {
    {"inside", 2, "layers that lie inside the grid", inside},
    {"edges", 2, "layers that are cut off by the edges", edges},
    {"across", 2, "layers that reach across the edges", across},
    {"half_way", 2, "layers that meet themselves half way round",
     half_way},
    {"large", 2, "grids of almost 10^18 cells", large},
    {0},
};
