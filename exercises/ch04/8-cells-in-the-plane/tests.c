// Tests of the cell sort in the plane: order and starts, against a list
// of points that is cut cell by cell, and time, against moving all
// points to places that are known beforehand.
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct points points;
static struct grid grid;
static struct sorted *sorted;
static uint32_t *place; // of every point, in the right order

static uint32_t cells(void)
{
    return grid.columns * grid.rows;
}

static bool exchanged; // cells numbered column by column

static uint32_t cell_of(uint32_t i)
{
    uint32_t k = cell_at(grid, points.x[i], points.y[i]);
    return exchanged ? k % grid.columns * grid.rows + k / grid.columns
                     : k;
}

static void prepare(struct points given, uint32_t columns,
                    uint32_t rows)
{
    points = given;
    grid = (struct grid){columns, rows};
    kit_given("%u points in %u columns and %u rows", points.n, columns,
              rows);
    sorted = kit_input("the sorted", 1, sizeof *sorted);
    *sorted = (struct sorted){
        kit_output("start", cells() + 1, sizeof(uint32_t)),
        kit_output("sorted x", points.n, sizeof(double)),
        kit_output("sorted y", points.n, sizeof(double)),
        kit_output("index", points.n, sizeof(uint32_t))};
}

// ---- the right order -----------------------------------------------

static int by_cell(const void *a, const void *b)
{
    uint32_t i = *(const uint32_t *)a, j = *(const uint32_t *)b;
    uint32_t k = cell_of(i), l = cell_of(j);
    return k != l ? (k > l) - (k < l) : (i > j) - (i < j);
}

// Which point stands where, found by comparisons.
static uint32_t *order(void)
{
    uint32_t *right = kit_input("the order", points.n, sizeof *right);
    for (uint32_t i = 0; i < points.n; i++)
        right[i] = i;
    qsort(right, points.n, sizeof *right, by_cell);
    return right;
}

// Whether all of it is the answer for cells that are numbered column by
// column.
static bool is_exchanged(void)
{
    exchanged = true;
    const uint32_t *other = order();
    bool same = true;
    for (uint32_t s = 0; s < points.n; s++)
        same = same && sorted->index[s] == other[s];
    for (uint32_t k = 0, s = 0; k <= cells(); k++) {
        while (s < points.n && cell_of(other[s]) < k)
            s++;
        same = same && sorted->start[k] == s;
    }
    exchanged = false;
    return same;
}

static const char exchange[] =
    "Columns and rows are exchanged: cells are numbered row by row.";

// Where cell k begins.
static uint32_t right_start(uint32_t k)
{
    uint32_t before = 0;
    for (uint32_t i = 0; i < points.n; i++)
        before += cell_of(i) < k;
    return before;
}

static const char *start_cause(uint32_t k, uint32_t right)
{
    if (is_exchanged())
        return exchange;
    const uint32_t unset = 0xa5a5a5a5, *start = sorted->start;
    if (start[k] - right >= unset - right && start[k] >= unset)
        return "Was this set to 0 before anything was counted? What "
               "the array held before means nothing.";
    if (k == cells())
        return "The last start is where the last cell ends.";
    if (right_start(k + 1) == start[k] && start[k] > right)
        return "This is where the cell ends. The loop that places must "
               "leave the beginnings behind.";
    return "A cell begins behind all points of all the cells before "
           "it, row by row.";
}

static void check_starts(const uint32_t *right)
{
    uint32_t s = 0;
    for (uint32_t k = 0; k <= cells(); k++) {
        while (s < points.n && cell_of(right[s]) < k)
            s++;
        if (sorted->start[k] != s)
            WRONG(.where = kit_text("start[%u]", k),
                  .expected = kit_text("%u", s),
                  .found = kit_text("%u", sorted->start[k]),
                  .cause = start_cause(k, s));
    }
}

static const char *order_cause(uint32_t right, uint32_t found)
{
    if (found >= points.n)
        return "This place was left free, or what was counted is not "
               "what was placed.";
    if (is_exchanged())
        return exchange;
    uint32_t k = cell_of(right), l = cell_of(found);
    if (k == l)
        return "The cell is right, but not the order in it: the points "
               "of a cell stand by ascending number. Filled from the "
               "end, a cell wants the last point first.";
    return "This point lies in another cell.";
}

static void check(void)
{
    CALL(STUDENT(sort_into_cells)(points, grid, sorted));
    const uint32_t *right = order();
    for (uint32_t s = 0; s < points.n; s++) {
        uint32_t found = sorted->index[s];
        if (found != right[s])
            WRONG(.where = kit_text("place %u, in cell %u", s,
                                    cell_of(right[s])),
                  .expected = kit_point(points, right[s]),
                  .found = kit_point(points, found),
                  .cause = order_cause(right[s], found));
        if (sorted->x[s] != points.x[found] ||
            sorted->y[s] != points.y[found])
            WRONG(.where = kit_text("the coordinates in place %u", s),
                  .expected = kit_point(points, found),
                  .found = kit_text("(%.9g, %.9g)", sorted->x[s],
                                    sorted->y[s]),
                  .cause = "The number has moved, its coordinates have "
                           "not: a point moves with all it has.");
    }
    check_starts(right);
    kit_next_case();
}

static void right(uint64_t seed)
{
    prepare(kit_points("uniform", 1000, seed), 20, 20);
    check();
    prepare(kit_points("uniform", 500, seed), 7, 30);
    check();
}

static void crowded(uint64_t seed)
{
    struct points set = kit_points("uniform", 200, seed);
    for (uint32_t i = 0; i < set.n; i++) {
        set.x[i] = i % 3 ? 0.5 : set.x[i];
        set.y[i] = i % 3 ? 0.25 : set.y[i];
    }
    prepare(set, 8, 8);
    check();
    prepare(kit_points("equal", 50, seed), 3, 5);
    check();
}

static void borders(uint64_t seed)
{
    for (uint32_t rows = 2; rows <= 8; rows *= 2) {
        struct points set = kit_points("uniform", 81, seed);
        for (uint32_t k = 0; k < set.n; k++) {
            uint32_t i = k * 50 % 81; // in no order
            set.x[i] = k % 9 / 8.0;
            set.y[i] = k / 9 / 8.0;
        }
        prepare(set, 8, rows);
        check();
    }
}

static void few(uint64_t seed)
{
    for (uint32_t n = 0; n <= 3; n++) {
        prepare(kit_points("uniform", n, seed), 1 + n, 5);
        check();
    }
    prepare(kit_points("uniform", 30, seed), 1, 1);
    check();
}

// ---- time ----------------------------------------------------------

enum { MANY = 1000000, SIDE = 707, SIDE_MAX = 5000 };

// Of the grid: 707, or of as many cells as CELLS= asks for, to see what
// becomes of the time.
static uint32_t side(void)
{
    const char *wanted = getenv("CELLS");
    double root = wanted ? sqrt(atof(wanted)) : SIDE;
    return root >= 1 && root <= SIDE_MAX ? (uint32_t)root : SIDE;
}

// To known places: no cell is found, nothing is counted.
static void move_all(void)
{
    for (uint32_t i = 0; i < MANY; i++) {
        sorted->x[place[i]] = points.x[i];
        sorted->y[place[i]] = points.y[i];
        sorted->index[place[i]] = i;
    }
}

static void ours(void)
{
    CALL(move_all());
}

static void theirs(void)
{
    CALL(STUDENT(sort_into_cells)(points, grid, sorted));
}

static void in_time(uint64_t seed)
{
    prepare(kit_points("uniform", 3000, seed), 40, 40);
    check();
    prepare(kit_points("uniform", MANY, seed), side(), side());
    const uint32_t *right = order();
    place = kit_input("the places", MANY, sizeof *place);
    for (uint32_t s = 0; s < MANY; s++)
        place[right[s]] = s;
    double ratio =
        kit_race((struct kit_race){theirs, ours, .cores = 1});
    kit_bands(ratio,
              (struct kit_band[]){{2.5, 6}, {3.2, 4}, {4, 2}, {0, 0}},
              (struct kit_fault){
                  .expected = "at most 2.5 times the time of moving "
                              "all points to known places",
                  .found = kit_text("%.1f times", ratio),
                  .cause = "Two passes over the points and one over "
                           "the cells are enough. Are points compared "
                           "with each other, or the cells gone through "
                           "one by one?"});
}

const struct kit_test kit_tests[] = {
    {"right", 1, "order, coordinates and starts", right},
    {"crowded", 1, "many points in one cell, in their order", crowded},
    {"borders", 1, "points on borders", borders},
    {"few", 1, "no points, one, one cell", few},
    {"time", 6, "a million points in 500,000 cells", in_time},
    {0},
};
