// Tests of the furthest point on the usual torus: answers, and counts
// against what is needed where the answer is known.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

enum { QUERIES = 200 };

static struct box box;
static uint32_t n, *start;
static double *px, *py; // of the points, sorted by cell
static double *qx, *qy; // of the queries

static uint32_t asked; // the query that is answered now

// What the student's process leaves behind for each query.
static struct notes {
    uint64_t measured, looked;
    bool no_place, no_cell;
    uint32_t found;
} * notes;

static uint32_t *visits; // of each cell, by the last query

static double around(double d, double size)
{
    return fmin(fabs(d), size - fabs(d));
}

static double square(double d)
{
    return d * d;
}

static double right2(uint32_t place, uint32_t q)
{
    return square(around(px[place] - qx[q], box.columns)) +
           square(around(py[place] - qy[q], box.rows));
}

struct span look(uint32_t column, uint32_t row)
{
    if (column >= box.columns || row >= box.rows) {
        notes[asked].no_cell = true;
        kit_leave();
    }
    uint32_t cell = row * box.columns + column;
    notes[asked].looked++;
    if (asked + 1 == QUERIES)
        visits[cell]++;
    return (struct span){start[cell], start[cell + 1]};
}

double measure(uint32_t place)
{
    if (place >= n) {
        notes[asked].no_place = true;
        kit_leave();
    }
    notes[asked].measured++;
    return right2(place, asked);
}

// ---- inputs --------------------------------------------------------

// A coordinate in [0, size), on multiples of 1 / fine.
static double coordinate(struct random *random, uint32_t size,
                         uint32_t fine)
{
    return (double)(random_bits(random) % ((uint64_t)size * fine)) /
           fine;
}

// Fills so many cells of a hundred, and puts queries anywhere.
static void lay(uint32_t columns, uint32_t rows, uint32_t per_cell,
                uint32_t percent, uint32_t fine, uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    box = (struct box){columns, rows};
    uint32_t cells = columns * rows;
    start = kit_input("start", cells + 1, sizeof *start);
    px = kit_input("x", (size_t)cells * per_cell, sizeof *px);
    py = kit_input("y", (size_t)cells * per_cell, sizeof *py);
    qx = kit_input("x of the queries", QUERIES, sizeof *qx);
    qy = kit_input("y of the queries", QUERIES, sizeof *qy);
    n = 0;
    for (uint32_t cell = 0; cell < cells; cell++) {
        start[cell] = n;
        bool last = cell + 1 == cells && n == 0;
        if (!last && random_bits(&random) % 100 >= percent)
            continue;
        uint32_t more = last ? 1 : 1 + random_bits(&random) % per_cell;
        for (; more > 0; more--, n++) {
            px[n] = cell % columns + coordinate(&random, 1, fine);
            py[n] = cell / columns + coordinate(&random, 1, fine);
        }
    }
    start[cells] = n;
    for (uint32_t q = 0; q < QUERIES; q++) {
        qx[q] = coordinate(&random, columns, fine);
        qy[q] = coordinate(&random, rows, fine);
    }
    kit_given("%u points in %u by %u cells, on multiples of 1/%u", n,
              columns, rows, fine);
}

// ---- what is right, and what is found by mistake -------------------

// How far an interval reaches from x, by one rule or another.
enum rule { RIGHT, ENDS, MIDDLE, FLAT };

static double reach(enum rule rule, double x, uint32_t k, uint32_t size)
{
    double antipode = fmod(x + size / 2.0, size);
    double a = fabs(k - x), b = fabs(k + 1.0 - x);
    if (rule == MIDDLE)
        return around(k + 0.5 - x, size);
    if (rule == FLAT)
        return fmax(a, b);
    if (rule == RIGHT && antipode >= k && antipode <= k + 1.0)
        return size / 2.0;
    return fmax(around(a, size), around(b, size));
}

static double bound2(enum rule rule, uint32_t cell, uint32_t q)
{
    return square(reach(rule, qx[q], cell % box.columns, box.columns)) +
           square(reach(rule, qy[q], cell / box.columns, box.rows));
}

static uint32_t right_answer(uint32_t q)
{
    uint32_t best = 0;
    for (uint32_t s = 1; s < n; s++)
        if (right2(s, q) > right2(best, q))
            best = s;
    return best;
}

static uint32_t furthest_by_book(uint32_t q)
{
    uint32_t best = 0;
    double best2 = -1;
    for (uint32_t s = 0; s < n; s++) {
        double dx = fabs(px[s] - qx[q]), dy = fabs(py[s] - qy[q]);
        double d2 = square(fmax(dx, box.columns - dx)) +
                    square(fmax(dy, box.rows - dy));
        if (d2 > best2) {
            best = s;
            best2 = d2;
        }
    }
    return best;
}

static uint32_t nearest_to_antipode(uint32_t q)
{
    double x = qx[q] + box.columns / 2.0, y = qy[q] + box.rows / 2.0;
    uint32_t best = 0;
    double best2 = INFINITY;
    for (uint32_t s = 0; s < n; s++) {
        double dx = fmod(fabs(px[s] - x), box.columns);
        double dy = fmod(fabs(py[s] - y), box.rows);
        double d2 = square(around(dx, box.columns)) +
                    square(around(dy, box.rows));
        if (d2 < best2) {
            best = s;
            best2 = d2;
        }
    }
    return best;
}

static uint32_t cell_of(uint32_t place)
{
    uint32_t cell = 0;
    while (start[cell + 1] <= place)
        cell++;
    return cell;
}

static const char *tell(uint32_t place, uint32_t q)
{
    if (place >= n)
        return kit_text("%u, which is no place", place);
    uint32_t cell = cell_of(place);
    return kit_text("place %u, in column %u, row %u, at (%.9g, %.9g), "
                    "distance %.9g",
                    place, cell % box.columns, cell / box.columns,
                    px[place], py[place], sqrt(right2(place, q)));
}

static const char *tell_query(uint32_t q)
{
    return kit_text("from (%.9g, %.9g), whose antipode is (%.9g, %.9g)",
                    qx[q], qy[q],
                    fmod(qx[q] + box.columns / 2.0, box.columns),
                    fmod(qy[q] + box.rows / 2.0, box.rows));
}

// What would explain a wrong answer.
enum mistake {
    TIE,
    TO_ANTIPODE,
    BY_BOOK,
    BY_ENDS,
    BY_MIDDLE,
    OTHERWISE
};

static bool explains(enum mistake mistake, uint32_t q)
{
    uint32_t found = notes[q].found, right = right_answer(q);
    double d2 = right2(found, q);
    switch (mistake) {
    case TIE:
        return d2 == right2(right, q);
    case TO_ANTIPODE:
        return found == nearest_to_antipode(q);
    case BY_BOOK:
        return found == furthest_by_book(q);
    case BY_ENDS:
        return bound2(ENDS, cell_of(right), q) < d2;
    case BY_MIDDLE:
        return bound2(MIDDLE, cell_of(right), q) < d2;
    default:
        return true;
    }
}

// Two of them must explain what was right as well.
static bool explains_all(enum mistake mistake)
{
    bool always = mistake == TO_ANTIPODE || mistake == BY_BOOK;
    for (uint32_t q = 0; q < QUERIES; q++)
        if (notes[q].found < n &&
            (always || notes[q].found != right_answer(q)) &&
            !explains(mistake, q))
            return false;
    return true;
}

// The first that explains all the wrong answers.
static enum mistake mistake_made(void)
{
    enum mistake mistake = TIE;
    while (!explains_all(mistake))
        mistake++;
    return mistake;
}

static const char *wrong_cause(uint32_t q)
{
    if (notes[q].found >= n)
        return "No point was ever taken: a cell may be empty, and all "
               "cells around the antipode may be.";
    switch (mistake_made()) {
    case TIE:
        return "These tie, and the other one has the lower place. Its "
               "cell may come later, with a bound that is just equal.";
    case TO_ANTIPODE:
        return "This one is the nearest to the antipode, and yet not "
               "the furthest from where you are: they are not the "
               "same.";
    case BY_BOOK:
        return "That is the furthest by the larger of d and P - d. "
               "Here it is the smaller one.";
    case BY_ENDS:
        return "Its cell was ruled out by the distances of its ends. "
               "Where it contains the antipode's column or row, the "
               "furthest place is between them.";
    case BY_MIDDLE:
        return "Its cell was ruled out. The middle of a cell is not "
               "the furthest place in it.";
    default:
        return "Its cell was left out, though its bound is high "
               "enough. A row that does not reach far enough, or has "
               "a point, says nothing about the next one, on the "
               "other side, nor a cell about the next cell.";
    }
}

static void ask_all(void)
{
    for (asked = 0; asked < QUERIES; asked++)
        notes[asked].found =
            STUDENT(furthest_on_torus)(box, qx[asked], qy[asked]);
}

static void check_answers(void)
{
    notes = kit_output("the answers", QUERIES, sizeof *notes);
    visits = kit_output("visits", (size_t)box.columns * box.rows,
                        sizeof *visits);
    for (uint32_t q = 0; q < QUERIES; q++)
        notes[q] = (struct notes){.found = UINT32_MAX};
    for (uint32_t cell = 0; cell < box.columns * box.rows; cell++)
        visits[cell] = 0;
    CALL(ask_all());
    for (uint32_t q = 0; q < QUERIES; q++) {
        uint32_t right = right_answer(q);
        if (notes[q].no_cell || notes[q].no_place)
            WRONG(.where = tell_query(q),
                  .expected = notes[q].no_cell ? "looks at cells"
                                               : "places of points",
                  .found = notes[q].no_cell
                               ? "look() called for none"
                               : "measure() called for none",
                  .cause = notes[q].no_cell
                               ? "What is beyond the last column or "
                                 "row is the first: take the "
                                 "remainder."
                               : "The points of a cell are in the "
                                 "places from begin up to, not "
                                 "including, end.");
        if (notes[q].found != right)
            WRONG(.where = tell_query(q), .expected = tell(right, q),
                  .found = tell(notes[q].found, q),
                  .cause = wrong_cause(q));
    }
    for (uint32_t cell = 0; cell < box.columns * box.rows; cell++)
        if (visits[cell] > 1)
            WRONG(.where = tell_query(QUERIES - 1),
                  .expected = "one look at a cell",
                  .found =
                      kit_text("%u at column %u, row %u", visits[cell],
                               cell % box.columns, cell / box.columns),
                  .cause = "Around a ring, the left and the right side "
                           "meet: where the number of cells is even, "
                           "in the same cell.");
}

// ---- counts --------------------------------------------------------

struct cost {
    uint64_t points, cells;
};

// What is in the cells that reach as far as the answer, by a rule.
static struct cost needed(enum rule rule)
{
    struct cost cost = {0, 0};
    for (uint32_t q = 0; q < QUERIES; q++) {
        double right_d2 = right2(notes[q].found, q);
        for (uint32_t cell = 0; cell < box.columns * box.rows; cell++)
            if (bound2(rule, cell, q) >= right_d2) {
                cost.points += start[cell + 1] - start[cell];
                cost.cells++;
            }
    }
    return cost;
}

static const char *cost_cause(uint64_t cells)
{
    if (cells >= (uint64_t)box.columns * box.rows * QUERIES)
        return "All cells were looked at, for each query. A cell that "
               "cannot reach as far as the best so far needs no look. "
               "Is the bound that of the larger of d and P - d?";
    if (10 * cells >= 9 * needed(FLAT).cells)
        return "Cells were looked at that seem far away because the "
               "box's edge lies between: there is a way around.";
    return "First to the cells that reach furthest, around the "
           "antipode: the sooner a good point is found, the more cells "
           "can be left out.";
}

static void check_counts(void)
{
    check_answers();
    uint64_t measured = 0, looked = 0;
    for (uint32_t q = 0; q < QUERIES; q++) {
        measured += notes[q].measured;
        looked += notes[q].looked;
    }
    struct cost right = needed(RIGHT);
    double mean = (double)measured / QUERIES;
    double enough = 2.0 * right.points / QUERIES;
    if (measured == 0)
        WRONG(.expected = "distances by measure()", .found = "none",
              .cause = "Where the points are only measure() knows.");
    if (mean > enough)
        WRONG(.expected =
                  kit_text("at most %.1f distances on average", enough),
              .found = kit_text("%.1f", mean),
              .cause = cost_cause(looked));
    if (looked > 3 * right.cells)
        WRONG(.expected = kit_text("at most %.1f cells on average",
                                   3.0 * right.cells / QUERIES),
              .found = kit_text("%.1f", (double)looked / QUERIES),
              .cause = cost_cause(looked));
}

// Right answers are not enough: at most half of the points.
static void check_prunes(void)
{
    check_answers();
    uint64_t measured = 0;
    for (uint32_t q = 0; q < QUERIES; q++)
        measured += notes[q].measured;
    if (2 * measured > (uint64_t)n * QUERIES)
        WRONG(.expected =
                  kit_text("at most %.1f of %u points measured, "
                           "on average",
                           n / 2.0, n),
              .found = kit_text("%.1f", (double)measured / QUERIES),
              .cause = "The answers are right, and most points were "
                       "measured. A cell that cannot reach as far as "
                       "the best so far needs no look.");
}

// ---- tests ---------------------------------------------------------

static void uniform(uint64_t seed)
{
    lay(20, 20, 3, 86, 1 << 16, seed);
    check_prunes();
    lay(9, 14, 3, 86, 1 << 16, seed);
    check_prunes();
}

static void empty(uint64_t seed)
{
    for (uint64_t k = 0; k < 10; k++) {
        lay(16, 13, 1, 1 + k, 1 << 16, seed + k);
        check_answers();
    }
}

static void lattice(uint64_t seed)
{
    lay(8, 8, 2, 90, 2, seed);
    check_answers();
    lay(7, 9, 2, 60, 1, seed);
    check_answers();
}

static void small(uint64_t seed)
{
    for (uint32_t k = 0; k < 16; k++) {
        lay(1 + k % 4, 1 + k / 4, 3, 60, 1 << (k % 3 * 8), seed + k);
        check_answers();
    }
}

static void counts(uint64_t seed)
{
    lay(40, 40, 3, 86, 1 << 16, seed);
    check_counts();
}

static void counts_oblong(uint64_t seed)
{
    lay(90, 24, 2, 50, 1 << 16, seed);
    check_counts();
    lay(25, 71, 4, 90, 1 << 16, seed);
    check_counts();
}

const struct kit_test kit_tests[] = {
    {"uniform", 2, "uniform points, half of them measured", uniform},
    {"empty", 1, "where most cells are empty", empty},
    {"lattice", 1, "the lowest place if several tie", lattice},
    {"small", 1, "boxes of a few cells", small},
    {"counts", 3, "few distances, few looks", counts},
    {"oblong", 2, "the same in oblong boxes", counts_oblong},
    {0},
};
