// Tests of the order of the queries: answers, the order in which they
// are looked for, calls, and time, against the order given.
#include "common/geometry.h"
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>
#include <string.h>

// Points in the order of their cells, in a square of side by side.
static struct points points;
static uint32_t side;
static const uint32_t *start; // side * side + 1

static struct notes {
    uint64_t searches, rows; // calls
    uint64_t descents;       // searches in a lower row than the last
    uint32_t last;
    bool outside; // a call for no place of the square
} * notes;

static uint32_t line_of(double x)
{
    uint32_t k = (uint32_t)(x * side);
    return k < side ? k : side - 1;
}

static uint32_t cell_of(double x, double y)
{
    return line_of(y) * side + line_of(x);
}

// Three rows of three cells; in each row they are one stretch.
static uint32_t search(double x, double y)
{
    uint32_t column = line_of(x), row = line_of(y), found = NO_INDEX;
    uint32_t left = column > 0 ? column - 1 : 0;
    uint32_t right = column + 1 < side ? column + 1 : column;
    double found2 = INFINITY;
    for (uint32_t r = row > 0 ? row - 1 : 0; r <= row + 1 && r < side;
         r++)
        for (uint32_t s = start[r * side + left];
             s < start[r * side + right + 1]; s++) {
            double d2 = distance2(points.x[s] - x, points.y[s] - y);
            if (d2 < found2) {
                found2 = d2;
                found = s;
            }
        }
    return found;
}

uint32_t row_count(void)
{
    return side;
}

static bool is_inside(double x, double y)
{
    bool is = x >= 0 && x <= 1 && y >= 0 && y <= 1;
    notes->outside |= !is;
    return is;
}

uint32_t row_at(double y)
{
    notes->rows++;
    return is_inside(0, y) ? line_of(y) : 0;
}

uint32_t find_nearest(double x, double y)
{
    if (!is_inside(x, y))
        return NO_INDEX;
    uint32_t row = line_of(y);
    notes->descents += row < notes->last;
    notes->last = row;
    notes->searches++;
    return search(x, y);
}

// ---- points and queries --------------------------------------------

struct queries {
    uint32_t n;
    double *x, *y;
    uint32_t *nearest;
};

static int by_cell(const void *a, const void *b)
{
    const double *p = a, *q = b;
    uint32_t k = cell_of(p[0], p[1]), l = cell_of(q[0], q[1]);
    return (k > l) - (k < l);
}

// n random places, by cell if they shall be.
static void draw(uint32_t n, bool in_order, double *x, double *y,
                 uint64_t seed)
{
    struct random random = {seed};
    double(*places)[2] = malloc((n + 1) * sizeof *places);
    for (uint32_t i = 0; i < n; i++) {
        places[i][0] = random_uniform(&random);
        places[i][1] = random_uniform(&random);
    }
    if (in_order)
        qsort(places, n, sizeof *places, by_cell);
    for (uint32_t i = 0; i < n; i++) {
        x[i] = places[i][0];
        y[i] = places[i][1];
    }
    free(places);
}

// As many points in each cell as in any other, or one more, and
// anywhere in it: so they come in the order of the cells.
static void lay_points(uint32_t n, uint32_t columns, uint64_t seed)
{
    struct random random = {seed};
    side = columns;
    points =
        (struct points){n, kit_input("points.x", n, sizeof(double)),
                        kit_input("points.y", n, sizeof(double))};
    const uint32_t cells = side * side;
    uint32_t *starts = kit_input("start", cells + 1, sizeof *starts);
    starts[0] = 0;
    for (uint32_t k = 0; k < cells; k++) {
        starts[k + 1] = (k + 1) * (uint64_t)n / cells;
        for (uint32_t s = starts[k]; s < starts[k + 1]; s++) {
            points.x[s] = (k % side + random_uniform(&random)) / side;
            points.y[s] = (k / side + random_uniform(&random)) / side;
        }
    }
    start = starts;
    notes = kit_output("the notes", 1, sizeof *notes);
}

static struct queries make_queries(uint32_t n, bool in_order,
                                   uint64_t seed)
{
    struct queries queries = {
        n, kit_input("x", n, sizeof(double)),
        kit_input("y", n, sizeof(double)),
        kit_output("nearest", n, sizeof(uint32_t))};
    draw(n, in_order, queries.x, queries.y, seed);
    kit_given("%u queries, %u points in %u cells", n, points.n,
              side * side);
    return queries;
}

// ---- answers and calls ---------------------------------------------

static const char *cause(struct queries queries, uint32_t q,
                         uint32_t right)
{
    uint32_t found = queries.nearest[q];
    if (found == 0xa5a5a5a5)
        return "This answer was never set. Is there a place in the "
               "order for every query?";
    for (uint32_t p = 0; p < queries.n; p++)
        if (found == search(queries.x[p], queries.y[p]) && p != q &&
            found != right)
            return kit_text("This is the answer to query %u. An answer "
                            "goes to the number of its query, not to "
                            "its place in the order.",
                            p);
    return "Is the search called with both coordinates of this query?";
}

static void check(struct queries queries)
{
    *notes = (struct notes){.searches = 0};
    CALL(STUDENT(answer_all)(queries.n, queries.x, queries.y,
                             queries.nearest));
    if (notes->outside)
        WRONG(.expected = "places of queries",
              .found = "a call for a place outside of the square",
              .cause = "Is every number in the order that of a query?");
    for (uint32_t q = 0; q < queries.n; q++) {
        uint32_t right = search(queries.x[q], queries.y[q]);
        if (queries.nearest[q] != right)
            WRONG(.where = kit_text("query %u at (%.9g, %.9g)", q,
                                    queries.x[q], queries.y[q]),
                  .expected = kit_text("point %u", right),
                  .found = kit_text("%u", queries.nearest[q]),
                  .cause = cause(queries, q, right));
    }
}

static void right(uint64_t seed)
{
    lay_points(1000, 20, seed);
    check(make_queries(700, false, seed + 1));
    kit_next_case();
    lay_points(300, 30, seed);
    check(make_queries(50, true, seed + 1));
}

static void few(uint64_t seed)
{
    for (uint32_t n = 0; n <= 4; n++) {
        lay_points(20, 1 + n, seed);
        check(make_queries(n, false, seed + n));
        kit_next_case();
    }
}

static void calls(uint64_t seed)
{
    lay_points(1000, 20, seed);
    struct queries queries = make_queries(2000, false, seed + 1);
    check(queries);
    if (notes->searches != queries.n)
        WRONG(.expected = "one search for each query",
              .found = kit_text("%ju searches for %u queries",
                                (uintmax_t)notes->searches, queries.n),
              .cause = "Each query is answered once.");
    if (notes->rows > 2 * (uint64_t)queries.n)
        WRONG(.expected = "at most two calls of row_at for a query",
              .found =
                  kit_text("%.1f", (double)notes->rows / queries.n),
              .cause = "Once to count and once to place is enough. Are "
                       "queries compared with each other?");
}

static void in_order(uint64_t seed)
{
    lay_points(4000, 40, seed);
    struct queries queries = make_queries(3000, false, seed + 1);
    check(queries);
    if (notes->descents > 0)
        WRONG(.expected = "searches in the order of the rows",
              .found = kit_text("%ju of %u in a lower row than the "
                                "one before",
                                (uintmax_t)notes->descents, queries.n),
              .cause = "Queries of one row want the same points, and "
                       "those of the next row nearly the same: sort "
                       "the queries by row, and answer them one after "
                       "the other.");
}

// ---- time ----------------------------------------------------------

enum { MANY = 1000000, COLUMNS = 1000, ASKED = 500000 };
static struct queries mixed;
static uint32_t *as_given; // their answers

static void ours(void)
{
    CALL(for (uint32_t q = 0; q < ASKED; q++) as_given[q] =
             find_nearest(mixed.x[q], mixed.y[q]));
}

static void theirs(void)
{
    CALL(STUDENT(answer_all)(ASKED, mixed.x, mixed.y, mixed.nearest));
}

static void in_time(uint64_t seed)
{
    lay_points(4000, 40, seed);
    check(make_queries(3000, false, seed + 1));
    kit_next_case();
    lay_points(MANY, COLUMNS, seed);
    mixed = make_queries(ASKED, false, seed + 1);
    as_given = kit_output("as given", ASKED, sizeof *as_given);
    *notes = (struct notes){.searches = 0};
    // What the caches hold changes from trial to trial.
    double ratio = kit_race(
        (struct kit_race){theirs, ours, .cores = 1, .trials = 15});
    kit_bands(ratio, (struct kit_band[]){{0.8, 4}, {0.9, 2}, {0, 0}},
              (struct kit_fault){
                  .expected = "at most 0.8 times the time of the same "
                              "queries in the order given",
                  .found = kit_text("%.2f times", ratio),
                  .cause = "Each query of a random order begins at a "
                           "place that no cache holds. To sort them "
                           "costs little, if they are counted and "
                           "placed and not compared."});
}

const struct kit_test kit_tests[] = {
    {"right", 1, "each query has its answer", right},
    {"few", 1, "from no query to four", few},
    {"calls", 1, "few calls of row_at, one search each", calls},
    {"in-order", 3, "searches in the order of the rows", in_order},
    {"time", 4, "half a million queries, a million points", in_time},
    {0},
};
