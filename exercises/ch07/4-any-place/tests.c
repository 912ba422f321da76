// Tests of queries anywhere: answers, against a search over all
// points, and the cells looked at, against what a spiral search may
// look at.
#include "common/geometry.h"
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

static struct points points, queries;
static struct grid grid;
static uint32_t *column_of, *row_of; // of every point
static uint32_t current;

// For every query the answer, and how often each cell was looked at;
// the last of these is for cells that there are not.
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
    return distance2(points.x[j] - queries.x[i],
                     points.y[j] - queries.y[i]);
}

// The nearest to query i in the columns and rows given.
static struct found search(uint32_t i, int64_t left, int64_t right,
                           int64_t bottom, int64_t top)
{
    struct found found = {NO_INDEX, INFINITY};
    for (uint32_t j = 0; j < points.n; j++)
        if (column_of[j] >= left && column_of[j] <= right &&
            row_of[j] >= bottom && row_of[j] <= top &&
            between(i, j) < found.nearest2)
            found = (struct found){j, between(i, j)};
    return found;
}

struct found look(uint32_t column, uint32_t row)
{
    if (column >= grid.columns || row >= grid.rows) {
        looks_of(current)[cells()]++;
        return (struct found){NO_INDEX, INFINITY};
    }
    looks_of(current)[row * grid.columns + column]++;
    return search(current, column, column, row, row);
}

// ---- the grid ------------------------------------------------------

static uint32_t cell_of(const double *border, uint32_t count, double x)
{
    uint32_t k = count - 1;
    while (k > 0 && x < border[k])
        k--;
    return k;
}

static const double *cut(double width, uint32_t count)
{
    double *border = kit_input("border", count + 1, sizeof *border);
    for (uint32_t k = 0; k <= count; k++)
        border[k] = width * k / count;
    return border;
}

// Lays a grid over the points, from (0, 0) to (width, height).
static void lay(struct points given, double width, double height,
                uint32_t columns, uint32_t rows)
{
    points = given;
    grid = (struct grid){columns, rows, cut(width, columns),
                         cut(height, rows)};
    column_of = kit_input("columns", points.n, sizeof *column_of);
    row_of = kit_input("rows", points.n, sizeof *row_of);
    for (uint32_t i = 0; i < points.n; i++) {
        column_of[i] =
            cell_of(grid.column_border, columns, points.x[i]);
        row_of[i] = cell_of(grid.row_border, rows, points.y[i]);
    }
}

static struct points room_for(uint32_t n)
{
    return (struct points){n, kit_input("x", n, sizeof(double)),
                           kit_input("y", n, sizeof(double))};
}

// Queries in a box around the middle, so many times as large.
static void put_queries(uint32_t n, double width, double height,
                        double times, uint64_t seed)
{
    struct random random = {seed + 1};
    queries = room_for(n);
    for (uint32_t i = 0; i < n; i++) {
        double u = random_uniform(&random) - 0.5;
        double v = random_uniform(&random) - 0.5;
        queries.x[i] = width * (0.5 + times * u);
        queries.y[i] = height * (0.5 + times * v);
    }
}

// ---- what a spiral search may look at ------------------------------

// How far column k is from x.
static double gap(const double *border, uint32_t k, double x)
{
    if (x < border[k])
        return border[k] - x;
    return x > border[k + 1] ? x - border[k + 1] : 0;
}

static double away(uint32_t i, uint32_t cell)
{
    return fmax(
        gap(grid.column_border, cell % grid.columns, queries.x[i]),
        gap(grid.row_border, cell / grid.columns, queries.y[i]));
}

struct phases {
    int64_t column, row;       // home
    int64_t layer;             // with which phase one ends
    struct found first, whole; // what it finds; one layer further
};

static struct phases phases_of(uint32_t i)
{
    struct phases p = {
        cell_of(grid.column_border, grid.columns, queries.x[i]),
        cell_of(grid.row_border, grid.rows, queries.y[i]),
        -1,
        {NO_INDEX, INFINITY},
        {NO_INDEX, INFINITY}};
    while (p.first.nearest == NO_INDEX) {
        p.layer++;
        p.first = search(i, p.column - p.layer, p.column + p.layer,
                         p.row - p.layer, p.row + p.layer);
    }
    int64_t k = p.layer + 1;
    p.whole =
        search(i, p.column - k, p.column + k, p.row - k, p.row + k);
    return p;
}

static int64_t layer_of(const struct phases *p, uint32_t cell)
{
    int64_t dx = (int64_t)(cell % grid.columns) - p->column;
    int64_t dy = (int64_t)(cell / grid.columns) - p->row;
    dx = dx < 0 ? -dx : dx, dy = dy < 0 ? -dy : dy;
    return dx > dy ? dx : dy;
}

// ---- answers -------------------------------------------------------

static const char *tell(struct found found)
{
    if (found.nearest == NO_INDEX)
        return "none";
    return kit_text("%s, squared distance %.17g",
                    kit_point(points, found.nearest), found.nearest2);
}

static bool outside(uint32_t i)
{
    return queries.x[i] < 0 || queries.y[i] < 0 ||
           queries.x[i] > grid.column_border[grid.columns] ||
           queries.y[i] > grid.row_border[grid.rows];
}

static const char *tell_query(uint32_t i)
{
    return kit_text("a query at (%.9g, %.9g), %s %u by %u cells",
                    queries.x[i], queries.y[i],
                    outside(i) ? "outside of" : "in", grid.columns,
                    grid.rows);
}

static const char *wrong_cause(uint32_t i, struct found right)
{
    struct found found = answers[i];
    struct phases p = phases_of(i);
    uint32_t cell =
        row_of[right.nearest] * grid.columns + column_of[right.nearest];
    bool looked_at = looks_of(i)[cell] > 0;
    if (looked_at && found.nearest2 == right.nearest2)
        return "These tie: the lower index is wanted, whichever "
               "cell was looked at first.";
    if (looked_at)
        return "Its cell was looked at, and then it was forgotten: is "
               "the best of each cell compared with the best so far?";
    if (found.nearest2 == right.nearest2)
        return "These tie, and the cell of the lower index just "
               "touches the square: the edge belongs to it.";
    if (found.nearest == NO_INDEX)
        return "The search ended before a point was found. Go on as "
               "long as there are cells.";
    if (found.nearest == p.first.nearest)
        return "This is the nearest of phase one. Layers are square: "
               "a point further out can be nearer.";
    if (found.nearest == p.whole.nearest)
        return "One layer more is not always enough: look as far as D "
               "reaches.";
    return "Its cell was never looked at, though it meets the square "
           "of side 2D around the query.";
}

static void check(void)
{
    uint32_t n = queries.n;
    answers = kit_output("the answers", n, sizeof *answers);
    looks = kit_output("the looks", (size_t)n * (cells() + 1),
                       sizeof *looks);
    memset(looks, 0, (size_t)n * (cells() + 1) * sizeof *looks);
    CALL(for (current = 0; current < n; current++) answers[current] =
             STUDENT(nearest_point)(&grid, queries.x[current],
                                    queries.y[current]));
    for (uint32_t i = 0; i < n; i++) {
        struct found right = search(i, 0, grid.columns, 0, grid.rows);
        if (looks_of(i)[cells()] > 0)
            WRONG(.where = tell_query(i),
                  .expected = "looks at cells of the grid",
                  .found = "a look at a cell that there is not",
                  .cause = "A layer may stick out of the grid. Only "
                           "the part inside has cells.");
        if (answers[i].nearest != right.nearest ||
            answers[i].nearest2 != right.nearest2)
            WRONG(.where = tell_query(i), .expected = tell(right),
                  .found = tell(answers[i]),
                  .cause = wrong_cause(i, right));
    }
}

// ---- looks ---------------------------------------------------------

// Whether a spiral search may look at a cell: in a layer up to that
// with which phase one ends, or within the square.
static bool may_look(const struct phases *p, uint32_t i, uint32_t cell)
{
    return layer_of(p, cell) <= p->layer ||
           away(i, cell) * away(i, cell) <= p->first.nearest2;
}

// Right answers are not enough: a search that stops has to look at
// fewer cells than there are, half-way to what it may, at most.
static void count_looks(void)
{
    uint64_t looked = 0, may = 0, all = 0;
    for (uint32_t i = 0; i < queries.n; i++) {
        struct phases p = phases_of(i);
        for (uint32_t k = 0; k < cells(); k++) {
            looked += looks_of(i)[k];
            may += may_look(&p, i, k);
            all++;
        }
    }
    if (2 * looked > may + all)
        WRONG(.where = kit_text("%u queries", queries.n),
              .expected = kit_text("about %.0f looks for each",
                                   (double)may / queries.n),
              .found = kit_text("%.0f, in a grid of %u cells",
                                (double)looked / queries.n, cells()),
              .cause = "Most of these cells are further away than what "
                       "has been found. When may the search stop?");
}

static void check_stops(void)
{
    check();
    count_looks();
}

static void check_once(void)
{
    check();
    for (uint32_t i = 0; i < queries.n; i++)
        for (uint32_t k = 0; k < cells(); k++)
            if (looks_of(i)[k] > 1)
                WRONG(.where = tell_query(i),
                      .expected =
                          kit_text("one look at cell (%u, %u)",
                                   k % grid.columns, k / grid.columns),
                      .found = kit_text("%u", looks_of(i)[k]),
                      .cause = "Each layer is a ring. What is inside "
                               "of it has been looked at, and a "
                               "corner belongs to one side only.");
    count_looks();
}

static void check_square(void)
{
    check_once();
    for (uint32_t i = 0; i < queries.n; i++) {
        struct phases p = phases_of(i);
        double d2 = p.first.nearest2;
        for (uint32_t k = 0; k < cells(); k++) {
            if (looks_of(i)[k] == 0 || may_look(&p, i, k))
                continue;
            WRONG(.where = tell_query(i),
                  .expected = kit_text(
                      "layers 0 to %d around (%u, %u), then cells at "
                      "most D = %.6g away",
                      (int)p.layer, (unsigned)p.column, (unsigned)p.row,
                      sqrt(d2)),
                  .found = kit_text("a look at cell (%u, %u) of layer "
                                    "%d, %.6g away",
                                    k % grid.columns, k / grid.columns,
                                    (int)layer_of(&p, k), away(i, k)),
                  .cause = "After phase one, look at a cell only if "
                           "its column and its row both meet the "
                           "square.");
        }
    }
}

// ---- the queries -------------------------------------------------

static void inside(uint64_t seed)
{
    lay(kit_points("uniform", 300, seed), 1, 1, 17, 17);
    put_queries(300, 1, 1, 1, seed);
    check();
    kit_next_case();
    lay(kit_points("clustered", 300, seed), 1, 1, 10, 20);
    put_queries(300, 1, 1, 1, seed);
    check();
}

static void from_outside(uint64_t seed)
{
    lay(kit_points("uniform", 200, seed), 1, 1, 14, 14);
    put_queries(300, 1, 1, 3, seed);
    check_stops();
    kit_next_case();
    lay(kit_points("uniform", 20, seed), 1, 1, 30, 1);
    put_queries(200, 1, 1, 9, seed);
    check_stops();
    kit_next_case();
    lay(kit_points("uniform", 1, seed), 1, 1, 13, 11);
    put_queries(200, 1, 1, 2, seed);
    kit_given("1 point in 13 by 11 cells");
    check_stops();
}

// A lattice, and queries between its points, on them and on borders.
static void ties(uint64_t seed)
{
    enum { SIDE = 9, N = SIDE * SIDE };
    (void)seed;
    struct points set = room_for(N);
    for (uint32_t k = 0; k < N; k++) {
        uint32_t i = k * 40 % N;
        set.x[i] = k % SIDE;
        set.y[i] = k / SIDE;
    }
    for (uint32_t count = 4; count <= 16; count *= 2) {
        lay(set, SIDE - 1, SIDE - 1, count, count);
        queries = room_for(25 * 25);
        for (uint32_t i = 0; i < queries.n; i++) {
            queries.x[i] = i % 25 / 2.0 - 2;
            queries.y[i] = i / 25 / 2.0 - 2;
        }
        kit_given("81 points of a lattice, and 625 queries");
        check_stops();
    }
}

static void once(uint64_t seed)
{
    lay(kit_points("uniform", 100, seed), 1, 1, 16, 16);
    put_queries(200, 1, 1, 1.5, seed);
    check_once();
}

static void square(uint64_t seed)
{
    lay(kit_points("uniform", 200, seed), 1, 1, 14, 14);
    put_queries(200, 1, 1, 1, seed);
    check_square();
    kit_next_case();
    lay(kit_points("clustered", 200, seed), 1, 1, 10, 20);
    put_queries(200, 1, 1, 1, seed);
    check_square();
    kit_next_case();
    lay(kit_points("uniform", 100, seed), 1, 1, 20, 20);
    put_queries(200, 1, 1, 2, seed);
    check_square();
}

const struct kit_test kit_tests[] = {
    {"inside", 3, "queries in the grid", inside},
    {"outside", 2, "outside, and with fewer looks than cells",
     from_outside},
    {"ties", 1, "ties and borders, with fewer looks", ties},
    {"once", 2, "no cell is looked at twice", once},
    {"square", 2, "layers of phase one, then the square", square},
    {0},
};
