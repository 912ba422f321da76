// Tests of the points that fool the block: searches in the block and
// everywhere, for every point.
#include "common/geometry.h"
#include "exercise.h"
#include "kit.h"

static int32_t cell(double x)
{
    return (int32_t)x;
}

static bool in_block(struct points points, uint32_t i, uint32_t j)
{
    int32_t columns = cell(points.x[i]) - cell(points.x[j]);
    int32_t rows = cell(points.y[i]) - cell(points.y[j]);
    return columns >= -1 && columns <= 1 && rows >= -1 && rows <= 1;
}

static double between(struct points points, uint32_t i, uint32_t j)
{
    return distance2(points.x[j] - points.x[i],
                     points.y[j] - points.y[i]);
}

// The nearest neighbor in the block or outside of it; i if there is
// none.
static uint32_t search(struct points points, uint32_t i, bool inside)
{
    uint32_t nearest = i;
    for (uint32_t j = 0; j < points.n; j++)
        if (j != i && in_block(points, i, j) == inside &&
            (nearest == i ||
             between(points, i, j) < between(points, i, nearest)))
            nearest = j;
    return nearest;
}

static bool is_fooled(struct points points, uint32_t i)
{
    uint32_t found = search(points, i, true);
    uint32_t missed = search(points, i, false);
    return found != i && missed != i &&
           between(points, i, missed) < between(points, i, found);
}

static bool on_border(struct points points, uint32_t i)
{
    return points.x[i] == cell(points.x[i]) ||
           points.y[i] == cell(points.y[i]);
}

// Why a point is not fooled.
static const char *cause(struct points points, uint32_t i)
{
    uint32_t found = search(points, i, true);
    uint32_t missed = search(points, i, false);
    if (found == i)
        return "Its block holds no other point. That is a search "
               "without an answer, not with a wrong one: it needs a "
               "decoy.";
    if (missed != i &&
        between(points, i, missed) == between(points, i, found))
        return "These tie, and of several nearest points any is right. "
               "The one outside must be nearer.";
    if (on_border(points, i) || on_border(points, found))
        return "A point on a border belongs to the cell that begins "
               "there, so these two are in cells that touch, and the "
               "one in the block is nearer than all others.";
    if (between(points, i, found) < 1)
        return "Less than the side of a cell apart, two points are in "
               "each other's blocks wherever they lie.";
    return "The point in its block is nearer than all others. No point "
           "in a block may be as near as those that it shall miss.";
}

static struct points place(uint32_t n)
{
    struct points points = {
        n,
        kit_output("points.x", n, sizeof *points.x),
        kit_output("points.y", n, sizeof *points.y),
    };
    kit_given("%u points", n);
    CALL(STUDENT(fool_the_block)(points));
    for (uint32_t i = 0; i < n; i++)
        if (!(points.x[i] >= 0 && points.x[i] < COLUMNS &&
              points.y[i] >= 0 && points.y[i] < ROWS))
            WRONG(.where = kit_text("point %u", i),
                  .expected = kit_text("x from 0, less than %d, y from "
                                       "0, less than %d",
                                       COLUMNS, ROWS),
                  .found = kit_point(points, i),
                  .cause = "It lies outside of the box, or was never "
                           "set. Is there room for as many fours as "
                           "you place in a row?");
    return points;
}

static const char *tell(struct points points, uint32_t i)
{
    uint32_t found = search(points, i, true);
    if (found == i)
        return "nothing in its block";
    return kit_text("%s in its block, distance %.9g",
                    kit_point(points, found),
                    sqrt(between(points, i, found)));
}

static void check(uint32_t n, uint32_t wanted)
{
    struct points points = place(n);
    uint32_t fooled = 0, honest = n;
    for (uint32_t i = n; i-- > 0;)
        if (is_fooled(points, i))
            fooled++;
        else
            honest = i;
    if (fooled >= wanted)
        return;
    WRONG(.where = kit_point(points, honest),
          .expected = kit_text("%u of %u points fooled", wanted, n),
          .found = kit_text("%u fooled; this one finds %s", fooled,
                            tell(points, honest)),
          .cause = cause(points, honest));
}

static void one(uint64_t seed)
{
    (void)seed;
    check(100, 1);
}

static void half(uint64_t seed)
{
    (void)seed;
    check(100, 50);
}

static void all(uint64_t seed)
{
    (void)seed;
    check(100, 100);
}

static void all_of_four(uint64_t seed)
{
    (void)seed;
    check(4, 4);
}

const struct kit_test kit_tests[] = {
    {"one", 2, "one point of a hundred is fooled", one},
    {"half", 2, "fifty of them are", half},
    {"all", 3, "all hundred are", all},
    {"all-of-four", 3, "four out of four", all_of_four},
    {0},
};
