// Tests of the block that grows: answers, against a search over all
// points, and the cells looked at, against the square that they must
// meet.
#include "common/geometry.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

static struct points points;
static struct grid grid;
static uint32_t *column_of, *row_of; // of every point
static uint32_t query;

// For every point its answer, and how often it looked at each cell; the
// last of these is for cells that there are not.
static struct found *answers;
static uint32_t *looks;

static uint32_t cells(void)
{
    return grid.columns * grid.rows;
}

static uint32_t *looks_of(uint32_t i)
{
    return looks + (size_t)i * (cells() + 1);
}

static double between(uint32_t i, uint32_t j)
{
    return distance2(points.x[j] - points.x[i],
                     points.y[j] - points.y[i]);
}

// The nearest neighbor of i in the columns and rows given.
static struct found search(uint32_t i, uint32_t left, uint32_t right,
                           uint32_t bottom, uint32_t top)
{
    struct found found = {NO_INDEX, INFINITY};
    for (uint32_t j = 0; j < points.n; j++)
        if (j != i && column_of[j] >= left && column_of[j] <= right &&
            row_of[j] >= bottom && row_of[j] <= top &&
            between(i, j) < found.nearest2)
            found = (struct found){j, between(i, j)};
    return found;
}

struct found look(uint32_t column, uint32_t row)
{
    if (column >= grid.columns || row >= grid.rows) {
        looks_of(query)[cells()]++;
        return (struct found){NO_INDEX, INFINITY};
    }
    looks_of(query)[row * grid.columns + column]++;
    return search(query, column, column, row, row);
}

// ---- the grid ------------------------------------------------------

static uint32_t cell_of(const double *border, uint32_t count, double x)
{
    uint32_t k = count - 1;
    while (k > 0 && x < border[k])
        k--;
    return k;
}

static const double *cut(double low, double high, uint32_t count)
{
    double *border = kit_input("border", count + 1, sizeof *border);
    for (uint32_t k = 0; k <= count; k++)
        border[k] = low + (high - low) * k / count;
    return border;
}

// Lays a grid over the points, from (0, 0) to (width, height).
static void lay(struct points given, double width, double height,
                uint32_t columns, uint32_t rows)
{
    points = given;
    grid = (struct grid){columns, rows, cut(0, width, columns),
                         cut(0, height, rows)};
    column_of = kit_input("columns", points.n, sizeof *column_of);
    row_of = kit_input("rows", points.n, sizeof *row_of);
    for (uint32_t i = 0; i < points.n; i++) {
        column_of[i] =
            cell_of(grid.column_border, columns, points.x[i]);
        row_of[i] = cell_of(grid.row_border, rows, points.y[i]);
    }
}

// ---- answers -------------------------------------------------------

// Where the rule of a likely mistake lets the block end.
enum rule { RIGHT, NO_TEST, TIES, NOT_SQUARED };

static bool enough(enum rule rule, double gap, double best2)
{
    switch (rule) {
    case NO_TEST:
        return best2 < INFINITY;
    case TIES:
        return gap * gap >= best2;
    case NOT_SQUARED:
        return gap > best2;
    default:
        return gap * gap > best2;
    }
}

// What is found by it.
static struct found grow_by(enum rule rule, uint32_t i)
{
    uint32_t left = column_of[i], right = left;
    uint32_t bottom = row_of[i], top = bottom;
    for (;;) {
        struct found best = search(i, left, right, bottom, top);
        double x = points.x[i], y = points.y[i];
        double gaps[] = {
            left > 0 ? x - grid.column_border[left] : INFINITY,
            right + 1 < grid.columns ? grid.column_border[right + 1] - x
                                     : INFINITY,
            bottom > 0 ? y - grid.row_border[bottom] : INFINITY,
            top + 1 < grid.rows ? grid.row_border[top + 1] - y
                                : INFINITY};
        int side = 0;
        for (int s = 1; s < 4; s++)
            side = gaps[s] < gaps[side] ? s : side;
        if (gaps[side] == INFINITY ||
            enough(rule, gaps[side], best.nearest2))
            return best;
        left -= side == 0;
        right += side == 1;
        bottom -= side == 2;
        top += side == 3;
    }
}

static struct found search_all(uint32_t i)
{
    return search(i, 0, grid.columns, 0, grid.rows);
}

static bool is_looked_at(uint32_t i, uint32_t j)
{
    return looks_of(i)[row_of[j] * grid.columns + column_of[j]] > 0;
}

static const char *wrong_cause(uint32_t i, struct found right)
{
    struct found found = answers[i];
    bool looked_at = is_looked_at(i, right.nearest);
    if (found.nearest == NO_INDEX && !looked_at)
        return "The block ended before a point was found.";
    if (looked_at && found.nearest2 == right.nearest2)
        return "These tie, and lie in different cells: the lower index "
               "is asked for, whichever cell was looked at first.";
    if (found.nearest2 == right.nearest2)
        return "These tie. The block ended though its border is just "
               "as near as the best point, and on that border stands "
               "one with a lower index.";
    if (looked_at)
        return "Its cell was looked at, and then it was forgotten: is "
               "the best of each new cell compared with the best so "
               "far?";
    if (found.nearest == grow_by(NO_TEST, i).nearest)
        return "The block ended when a point was found. Beyond a "
               "border that is nearer than this point may be one that "
               "is nearer, too.";
    if (found.nearest == grow_by(NOT_SQUARED, i).nearest)
        return "A distance is compared with a squared one: square the "
               "distance to the border.";
    return "Its cell was never looked at. Is every border of the "
           "block further away than the best point, on all four "
           "sides, when you stop?";
}

static const char *tell(struct found found)
{
    if (found.nearest == NO_INDEX)
        return "no point";
    return kit_text("%s, squared distance %.17g",
                    kit_point(points, found.nearest), found.nearest2);
}

static const char *tell_query(uint32_t i)
{
    return kit_text("%s in cell (%u, %u) of %u by %u",
                    kit_point(points, i), column_of[i], row_of[i],
                    grid.columns, grid.rows);
}

static void check(void)
{
    answers = kit_output("the answers", points.n, sizeof *answers);
    looks = kit_output("the looks", (size_t)points.n * (cells() + 1),
                       sizeof *looks);
    memset(looks, 0, (size_t)points.n * (cells() + 1) * sizeof *looks);
    CALL(for (query = 0; query < points.n; query++) answers[query] =
             STUDENT(grow)(&grid, column_of[query], row_of[query],
                           points.x[query], points.y[query]));
    for (uint32_t i = 0; i < points.n; i++) {
        struct found right = search_all(i);
        if (looks_of(i)[cells()] > 0)
            WRONG(.where = tell_query(i),
                  .expected = "looks at cells of the grid",
                  .found = "a look at a cell that there is not",
                  .cause = "The block has reached the edge of the "
                           "grid. Beyond is nothing to look at, and "
                           "nothing to fear.");
        if (answers[i].nearest != right.nearest ||
            answers[i].nearest2 != right.nearest2)
            WRONG(.where = tell_query(i), .expected = tell(right),
                  .found = tell(answers[i]),
                  .cause = wrong_cause(i, right),
                  .picture = {points,
                              {i, answers[i].nearest},
                              {i, right.nearest}},
                  .cells = {grid.columns, grid.rows, grid.column_border,
                            grid.row_border});
    }
}

// ---- looks ---------------------------------------------------------

static void check_once(void)
{
    check();
    for (uint32_t i = 0; i < points.n; i++)
        for (uint32_t k = 0; k < cells(); k++)
            if (looks_of(i)[k] > 1)
                WRONG(.where = tell_query(i),
                      .expected =
                          kit_text("one look at cell (%u, %u)",
                                   k % grid.columns, k / grid.columns),
                      .found = kit_text("%u", looks_of(i)[k]),
                      .cause =
                          "When the block grows, only the new strip "
                          "has anything to tell: what is inside has "
                          "been looked at, the own cell, too.");
}

// A block that stops somewhere, and looks at no cell again and again.
static void check_stops(void)
{
    check();
    uint64_t found = 0;
    for (uint32_t k = 0; k < points.n * (cells() + 1); k++)
        found += looks[k];
    double share = (double)found / points.n / cells();
    if (share > 0.25)
        WRONG(.expected = kit_text("looks at less than a quarter of "
                                   "the %u cells, for a query",
                                   cells()),
              .found = kit_text("at %.0f percent of them", 100 * share),
              .cause = "The neighbor is near. Beyond a border that is "
                       "further away than the best so far, there is "
                       "nothing to find.");
}

// How far the cells of one coordinate begin from x; 0 in its own.
static double gap(const double *border, uint32_t own, uint32_t k,
                  double x)
{
    return k < own ? x - border[k + 1] : k > own ? border[k] - x : 0;
}

// How far a cell is from the query, in x or in y.
static double away_from(uint32_t i, uint32_t k)
{
    return fmax(
        gap(grid.column_border, column_of[i], k % grid.columns,
            points.x[i]),
        gap(grid.row_border, row_of[i], k / grid.columns, points.y[i]));
}

static void check_square(void)
{
    check_once();
    for (uint32_t i = 0; i < points.n; i++) {
        double d2 = search_all(i).nearest2;
        for (uint32_t k = 0; k < cells(); k++) {
            double away = away_from(i, k);
            if (looks_of(i)[k] == 0 || away * away <= d2)
                continue;
            WRONG(.where = tell_query(i),
                  .expected = kit_text("cells at most %.6g away, the "
                                       "distance to the nearest",
                                       sqrt(d2)),
                  .found = kit_text("a look at cell (%u, %u), %.6g "
                                    "away",
                                    k % grid.columns, k / grid.columns,
                                    away),
                  .cause =
                      "Begin with the query's own cell. When the block "
                      "grew to this cell, another side had to grow in "
                      "any case, and what lies there makes this cell "
                      "needless.");
        }
    }
}

// ---- the sets ------------------------------------------------------

// A lattice of 13 by 13 points, numbered in no order.
static struct points lattice(void)
{
    enum { SIDE = 13, N = SIDE * SIDE };
    struct points set = {N, kit_input("points.x", N, sizeof(double)),
                         kit_input("points.y", N, sizeof(double))};
    for (uint32_t k = 0; k < N; k++) {
        uint32_t i = k * 100 % N;
        set.x[i] = k % SIDE;
        set.y[i] = k / SIDE;
    }
    return set;
}

static void right(uint64_t seed)
{
    lay(kit_points("uniform", 300, seed), 1, 1, 12, 12);
    check_stops();
    kit_next_case();
    lay(kit_points("clustered", 300, seed), 1, 1, 10, 20);
    check();
    kit_next_case();
    struct points large = kit_points("uniform", 200, seed);
    for (uint32_t i = 0; i < large.n; i++)
        large.x[i] *= 1e3, large.y[i] *= 1e3;
    kit_given("200 points in a square of side 1000");
    lay(large, 1e3, 1e3, 20, 20);
    check_stops();
}

static void ties(uint64_t seed)
{
    lay(lattice(), 12, 12, 12, 12);
    kit_given("169 points on the corners of 144 cells");
    check();
    kit_next_case();
    lay(lattice(), 12, 12, 6, 6);
    kit_given("169 points on corners, on borders and inside");
    check();
    kit_next_case();
    struct points set = kit_points("uniform", 40, seed);
    for (uint32_t i = 0; i < set.n; i++)
        set.x[i] = set.y[i] = 0.5;
    kit_given("40 points in one place, on a border");
    lay(set, 1, 1, 4, 4);
    check();
}

static void lonely(uint64_t seed)
{
    struct points set = kit_points("uniform", 3, seed);
    set.x[0] = set.y[0] = set.y[1] = 0;
    set.x[1] = set.x[2] = set.y[2] = 1;
    kit_given("3 points in the corners of many cells");
    lay(set, 1, 1, 15, 11);
    check();
    kit_next_case();
    lay(kit_points("uniform", 20, seed), 1, 1, 30, 1);
    check();
    kit_next_case();
    lay(kit_points("uniform", 20, seed), 1, 1, 1, 30);
    check();
    kit_next_case();
    lay(kit_points("uniform", 2, seed), 1, 1, 1, 1);
    check();
}

static void once(uint64_t seed)
{
    lay(kit_points("uniform", 100, seed), 1, 1, 14, 14);
    check_stops();
    check_once();
}

static void square(uint64_t seed)
{
    lay(kit_points("uniform", 400, seed), 1, 1, 14, 14);
    check_square();
    kit_next_case();
    lay(kit_points("clustered", 200, seed), 1, 1, 10, 20);
    check_square();
}

const struct kit_test kit_tests[] = {
    {"right", 2, "the right neighbors, and an end", right},
    {"ties", 1, "ties, and points on borders", ties},
    {"lonely", 1, "few points in many cells, one row, one cell",
     lonely},
    {"once", 2, "no cell is looked at twice", once},
    {"square", 4, "only cells that reach into the square", square},
    {0},
};
