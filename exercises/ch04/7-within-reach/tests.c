// Tests of the pairs closer than r: the pairs, against a search over
// all, and the count of the distances, against half a block.
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>

// The case, and what the student's process did.
static struct points points;
static struct space space;
static double reach; // r
static struct notes {
    uint64_t measured, taken; // of pairs, whichever
    bool not_a_pair;          // i == j, or no index
} * notes;
static uint32_t *times; // each pair was taken; pair_of(i, j)

static size_t pair_of(uint32_t i, uint32_t j)
{
    return i < j ? (size_t)j * (j - 1) / 2 + i
                 : (size_t)i * (i - 1) / 2 + j;
}

static double between(uint32_t i, uint32_t j)
{
    return closest2(space, points.x[j] - points.x[i],
                    points.y[j] - points.y[i]);
}

static bool is_pair(uint32_t i, uint32_t j)
{
    bool is = i < points.n && j < points.n && i != j;
    notes->not_a_pair |= !is;
    return is;
}

double measure(uint32_t i, uint32_t j)
{
    notes->measured++;
    return is_pair(i, j) ? between(i, j) : INFINITY;
}

void take_pair(uint32_t i, uint32_t j)
{
    notes->taken++;
    if (is_pair(i, j))
        times[pair_of(i, j)]++;
}

// ---- cells as wide as r, for the causes and the counts -------------

struct place {
    uint32_t column, row;
};

static uint32_t count_cells(double length)
{
    double cells = floor(length / reach);
    return cells < 1 ? 1 : cells > 10000 ? 10000 : (uint32_t)cells;
}

static uint32_t cell_of(double x, double length)
{
    uint32_t count = count_cells(length);
    uint32_t k = (uint32_t)(x / length * count);
    return k < count ? k : count - 1;
}

static struct place place_of(uint32_t i)
{
    return (struct place){cell_of(points.x[i], space.width),
                          cell_of(points.y[i], space.height)};
}

// How many pairs share a cell or half a block.
static uint64_t half_block_pairs(void)
{
    const uint32_t columns = count_cells(space.width);
    const uint32_t rows = count_cells(space.height);
    uint32_t *count = calloc((size_t)columns * rows, sizeof *count);
    for (uint32_t i = 0; i < points.n; i++)
        count[place_of(i).row * columns + place_of(i).column]++;
    uint64_t pairs = 0;
    for (uint32_t row = 0; row < rows; row++)
        for (uint32_t column = 0; column < columns; column++) {
            uint64_t here = count[row * columns + column];
            uint32_t above = (row + 1) % rows * columns;
            uint32_t right = (column + 1) % columns;
            uint32_t left = (column + columns - 1) % columns;
            uint64_t half =
                count[row * columns + right] + count[above + left] +
                count[above + column] + count[above + right];
            pairs += here * half + here * (here - 1) / 2;
        }
    free(count);
    return pairs;
}

// ---- the pairs -----------------------------------------------------

static const char *tell(uint32_t i, uint32_t j)
{
    return kit_text("%s and %s, %.9g apart", kit_point(points, i),
                    kit_point(points, j), sqrt(between(i, j)));
}

static const char *missing_cause(uint32_t i, uint32_t j)
{
    if (reach > space.width || reach > space.height)
        return "The radius is larger than the box: is there a grid "
               "at all, with at least one column and one row?";
    double dx = fabs(points.x[i] - points.x[j]);
    double dy = fabs(points.y[i] - points.y[j]);
    if (dx > space.width / 2 || dy > space.height / 2)
        return "These are neighbors across the border of the box: the "
               "first column follows the last one, the first row the "
               "last row.";
    struct place a = place_of(i), b = place_of(j);
    if (a.column == b.column && a.row == b.row)
        return "In cells as wide as r, these two share one.";
    if (a.column != b.column && a.row != b.row)
        return "In cells as wide as r, theirs touch at a corner: half "
               "of a block has two of the four corners, and not "
               "opposite ones.";
    return "In cells as wide as r, theirs lie side by side. Half of a "
           "block has two of the four sides, and not opposite ones.";
}

static const char *twice_cause(uint32_t i, uint32_t j)
{
    struct place a = place_of(i), b = place_of(j);
    if (a.column == b.column && a.row == b.row &&
        count_cells(space.width) > 1 && count_cells(space.height) > 1)
        return "In a cell, each pair once: (i, j), but not (j, i).";
    if (count_cells(space.width) < 3 || count_cells(space.height) < 3)
        return "With two columns, a cell has the same neighbor on the "
               "left and on the right; with one, it is its own. Rows "
               "likewise.";
    return "A pair in two cells was found from both sides: of opposite "
           "neighbors, search only one.";
}

static void check_pair(uint32_t i, uint32_t j)
{
    uint32_t found = times[pair_of(i, j)];
    bool close = between(i, j) < reach * reach;
    if (found == close)
        return;
    if (!close)
        WRONG(.where = tell(i, j),
              .expected =
                  kit_text("only pairs closer than %.9g", reach),
              .found = "taken",
              .cause = between(i, j) == reach * reach
                           ? "They are exactly r apart, and not closer."
                           : "measure() gives the squared distance: "
                             "compare it with the square of r.");
    if (found == 0)
        WRONG(.where = tell(i, j), .expected = "taken once",
              .found = "not taken", .cause = missing_cause(i, j));
    WRONG(.where = tell(i, j), .expected = "taken once",
          .found = kit_text("%u times", found),
          .cause = twice_cause(i, j));
}

static void check(struct points given, double width, double height,
                  double r)
{
    points = given;
    space = (struct space){WRAPAROUND, width, height};
    reach = r;
    kit_given("%u points in a box of %g by %g, r = %.9g", points.n,
              width, height, r);
    size_t pairs = (size_t)points.n * (points.n - 1) / 2;
    times = kit_output("the pairs", pairs + 1, sizeof *times);
    for (size_t p = 0; p < pairs; p++)
        times[p] = 0;
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){.measured = 0};
    CALL(STUDENT(pairs_within)(points, space, r));
    if (notes->not_a_pair)
        WRONG(.expected = "pairs of two points",
              .found = "a point with itself, or with an index that no "
                       "point has",
              .cause = "A point is no partner of itself. With few "
                       "columns and rows, a cell may be its own "
                       "neighbor.");
    for (uint32_t i = 0; i < points.n; i++)
        for (uint32_t j = i + 1; j < points.n; j++)
            check_pair(i, j);
}

static uint64_t all_pairs(void)
{
    return (uint64_t)points.n * (points.n - 1) / 2;
}

// Cells there must be, or most pairs would be measured.
static void check_cells(void)
{
    if (notes->measured > all_pairs() / 2)
        WRONG(.expected = kit_text("less than half of all %ju pairs "
                                   "measured",
                                   (uintmax_t)all_pairs()),
              .found = kit_text("%ju", (uintmax_t)notes->measured),
              .cause = "The pairs are right, but most of those "
                       "measured are far apart: sort the points into "
                       "cells first.");
}

// Fills the box with one of the book's distributions.
static struct points fill(const char *distribution, uint32_t n,
                          double width, double height, uint64_t seed)
{
    struct points filled = kit_points(distribution, n, seed);
    for (uint32_t i = 0; i < n; i++) {
        filled.x[i] = fmin(width * filled.x[i], width);
        filled.y[i] = fmin(height * filled.y[i], height);
    }
    return filled;
}

static void right(uint64_t seed)
{
    check(fill("uniform", 500, 1, 1, seed), 1, 1, 0.083);
    check_cells();
    kit_next_case();
    check(fill("uniform", 400, 30, 7, seed), 30, 7, 1.1);
    check_cells();
    kit_next_case();
    check(fill("uniform", 400, 0.01, 0.02, seed), 0.01, 0.02, 0.0013);
    check_cells();
}

// All combinations of up to four columns and rows, and none at all.
static void few_cells(uint64_t seed)
{
    const double sides[] = {0.3, 1, 2, 3, 3.5};
    for (int a = 0; a < 5; a++)
        for (int b = 0; b < 5; b++) {
            check(fill("uniform", 60, sides[a], sides[b], seed),
                  sides[a], sides[b], 0.8);
            kit_next_case();
        }
}

// Points on the borders of cells and of the box, on top of each other,
// and exactly r apart.
static void on_borders(uint64_t seed)
{
    const double radii[] = {0.125, 0.1, 1 / 3.0, 0.7};
    for (int k = 0; k < 4; k++) {
        struct points set = kit_points("uniform", 2 * 49, seed);
        for (uint32_t i = 0; i < set.n; i++) {
            set.x[i] = i % 7 * radii[k];
            set.y[i] = i / 7 % 7 * radii[k];
        }
        check(set, 6 * radii[k], 8 * radii[k], radii[k]);
        kit_next_case();
    }
}

static void odd_sets(uint64_t seed)
{
    check(fill("uniform", 1, 1, 1, seed), 1, 1, 0.1);
    kit_next_case();
    check(fill("uniform", 2, 1, 1, seed), 1, 1, 1);
    kit_next_case();
    struct points set = kit_points("uniform", 50, seed);
    for (uint32_t i = 0; i < set.n; i++)
        set.x[i] = set.y[i] = i % 2 ? 1 : 0.5;
    check(set, 1, 1, 0.01);
}

// A grid of cells that small would fit into no memory.
static void tiny(uint64_t seed)
{
    const double radii[] = {1e-7, 1e-12, 1e-150};
    for (int k = 0; k < 3; k++) {
        struct points set = kit_points("uniform", 300, seed);
        set.x[7] = set.x[3] = 0;
        set.y[7] = set.y[3];
        set.x[5] = 1;
        set.y[5] = set.y[3];
        check(set, 1, 1, radii[k]);
        check_cells();
        kit_next_case();
    }
}

static const char *cost_cause(uint64_t enough)
{
    if (notes->measured == 0)
        return "Only measure() may compute a distance.";
    if (notes->measured >= all_pairs())
        return "That is every pair there is.";
    if (notes->measured > 1.8 * enough &&
        notes->measured < 2.3 * enough)
        return "That is twice as many: each pair is measured from both "
               "sides. Half of a block is enough.";
    return "Are the cells as small as the radius allows?";
}

static void count(uint64_t seed)
{
    check(fill("uniform", 3000, 1, 1, seed), 1, 1, 0.0237);
    uint64_t enough = half_block_pairs();
    if (notes->measured == 0 || notes->measured > enough * 1.1)
        WRONG(.expected =
                  kit_text("about %ju distances, a tenth more at most",
                           (uintmax_t)enough),
              .found = kit_text("%ju", (uintmax_t)notes->measured),
              .cause = cost_cause(enough));
}

const struct kit_test kit_tests[] = {
    {"right", 2, "the pairs of random points", right},
    {"few-cells", 2, "four columns or rows, or fewer", few_cells},
    {"on-borders", 1, "points on borders and exactly r apart",
     on_borders},
    {"odd-sets", 1, "one point, two, all in two places", odd_sets},
    {"tiny", 1, "a tiny radius, but not as many cells", tiny},
    {"count", 3, "few distances, 3,000 uniform points", count},
    {0},
};
