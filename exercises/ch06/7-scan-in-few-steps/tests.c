// Tests of the scan: that each sum is one of the right elements, how
// many joins there were, and how many had to wait for each other. A sum
// is known to the tests as a range of elements.
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <string.h>

enum { SUMS_MOST = 1 << 20 };

struct range {
    uint32_t first, end; // of elements
    uint32_t depth;      // joins in a chain that led to it
};

enum fault { NONE, UNKNOWN, REVERSED, GAP, OVERLAP, TOO_MANY };
static const char *const fault_causes[] = {
    [UNKNOWN] = "An element of an array was read before it was set, or "
                "after it was overwritten.",
    [REVERSED] = "The left sum comes first. Not every sum is one of "
                 "numbers, and joining may not commute.",
    [GAP] = "The elements between the two would be left out: the right "
            "sum begins where the left one ends. Was a sum overwritten "
            "that was still needed?",
    [OVERLAP] = "Some elements would be in the sum twice: the right "
                "sum begins where the left one ends.",
    [TOO_MANY] = "Is every sum made anew from its elements? The sum "
                 "before it has most of them.",
};

const struct sum nothing = {0};

// In the student's process only.
static struct range sums[SUMS_MOST];
static uint32_t names;

// What it leaves behind.
static struct {
    uint64_t joins;
    enum fault fault;
    struct range left, right; // of the join that was refused
} * record;
static struct range *result;

static _Noreturn void refuse(enum fault fault, struct range left,
                             struct range right)
{
    record->fault = fault;
    record->left = left;
    record->right = right;
    kit_leave();
}

static struct range look_up(struct sum sum)
{
    if (sum.name >= names)
        refuse(UNKNOWN, sums[0], sums[0]);
    return sums[sum.name];
}

struct sum join(struct sum left, struct sum right)
{
    struct range a = look_up(left), b = look_up(right);
    if (left.name == nothing.name)
        return right;
    if (right.name == nothing.name)
        return left;
    if (b.end <= a.first)
        refuse(REVERSED, a, b);
    if (b.first != a.end)
        refuse(b.first > a.end ? GAP : OVERLAP, a, b);
    if (names == SUMS_MOST)
        refuse(TOO_MANY, a, b);
    record->joins++;
    sums[names] = (struct range){
        a.first, b.end, 1 + (a.depth > b.depth ? a.depth : b.depth)};
    return (struct sum){names++};
}

// ---- calling the student -------------------------------------------

static const char *tell(struct range range)
{
    if (range.first == range.end)
        return "nothing";
    if (range.end > SUMS_MOST)
        return "no sum at all";
    if (range.end - range.first == 1)
        return kit_text("element %u", range.first);
    return kit_text("elements %u to %u", range.first, range.end - 1);
}

static void report_fault(void)
{
    if (record->fault == NONE)
        return;
    const char *found =
        record->fault == UNKNOWN ? "a sum that was never made"
        : record->fault == TOO_MANY
            ? "a million joins, and no end"
            : kit_text("%s on the left, %s on the right",
                       tell(record->left), tell(record->right));
    WRONG(.expected = "joins of neighbors", .found = found,
          .cause = fault_causes[record->fault]);
}

static const char *cause(uint32_t n, uint32_t i, struct range found)
{
    if (found.end > n)
        return i == n - 1 && n % 2 && n > 1
                   ? "If n is odd, the last element has no partner, "
                     "but its place has a result."
                   : "This element was never set.";
    if (i == 0)
        return "Before the first element there is nothing, and to[0] "
               "says so. Or is this the inclusive scan?";
    if (found.first == 0 && found.end == i + 1)
        return "This is the inclusive scan. In an exclusive one, an "
               "element's own value does not belong to its sum.";
    if (found.first == 0)
        return "A sum of the first elements, but of too many or too "
               "few: it belongs to another place.";
    return "The sum does not begin with the first element: what comes "
           "before the block, or the pair, is missing.";
}

// What was never set stays nonsense.
static void look_up_all(uint32_t n, const struct sum *to)
{
    for (uint32_t i = 0; i < n; i++)
        if (to[i].name < names)
            result[i] = sums[to[i].name];
}

static void call(uint32_t n)
{
    kit_given("%u elements", n);
    record = kit_output("the record", 1, sizeof *record);
    memset(record, 0, sizeof *record);
    result = kit_output("the result", n, sizeof *result);
    struct sum *from = kit_input("from", n, sizeof *from);
    struct sum *to = kit_output("to", n, sizeof *to);
    sums[nothing.name] = (struct range){0, 0, 0};
    for (uint32_t i = 0; i < n; i++) {
        from[i] = (struct sum){1 + i};
        sums[1 + i] = (struct range){i, i + 1, 0};
    }
    names = 1 + n;
    CALL(STUDENT(scan)(n, from, to); look_up_all(n, to));
    report_fault();
    for (uint32_t i = 0; i < n; i++) {
        struct range right = {0, i, 0};
        if (result[i].end != i || (i > 0 && result[i].first != 0))
            WRONG(.where = kit_text("to[%u]", i),
                  .expected = tell(right), .found = tell(result[i]),
                  .cause = cause(n, i, result[i]));
    }
}

// ---- joins and steps -----------------------------------------------

static uint32_t deepest(uint32_t n)
{
    uint32_t depth = 0;
    for (uint32_t i = 0; i < n; i++)
        if (result[i].depth > depth)
            depth = result[i].depth;
    return depth;
}

static const char *steps_cause(uint32_t n, uint32_t depth)
{
    if (depth + 2 >= n)
        return "Every join waits for the one before it. Sums of blocks "
               "do not have to wait for each other.";
    if (depth <= 4 * sqrt(n) + 1)
        return "The blocks are scanned step by step, and so are their "
               "sums. Make the blocks as small as can be, and do with "
               "their sums what you do with the elements.";
    return "Look at the longest chain: a block, then the sums of the "
           "blocks, then a block. Is a block too long, or are there "
           "too many? Do the last places wait for all the others?";
}

static uint32_t levels(uint32_t n)
{
    uint32_t levels = 0;
    while (UINT64_C(1) << levels < n)
        levels++;
    return levels;
}

static void check_price(uint32_t n, uint64_t joins, uint32_t steps)
{
    call(n);
    uint32_t depth = deepest(n);
    bool anew = record->joins > (uint64_t)n * levels(n);
    if (depth > steps && !anew)
        WRONG(.expected = kit_text("at most %u steps", steps),
              .found = kit_text("%u", depth),
              .cause = steps_cause(n, depth));
    if (record->joins > joins)
        WRONG(.expected =
                  kit_text("at most %ju joins", (uintmax_t)joins),
              .found = kit_text("%ju, in %u steps",
                                (uintmax_t)record->joins, depth),
              .cause = anew ? fault_causes[TOO_MANY]
                            : "Few steps, but in most of them "
                              "every lane joins something. Join pairs, "
                              "and only the pairs take part in what "
                              "follows.");
    kit_next_case();
}

static void check_tree(uint32_t n)
{
    check_price(n, 2 * (uint64_t)n, 2 * levels(n));
}

static void right(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 0; n <= 70; n++) {
        call(n);
        kit_next_case();
    }
}

static void blocks(uint64_t seed)
{
    (void)seed;
    for (uint32_t side = 10; side <= 100; side += 30)
        for (uint32_t n = side * side - 1; n <= side * side + 1; n++)
            check_price(n, 3 * n, 4 * side);
}

static void tree(uint64_t seed)
{
    (void)seed;
    check_tree(1 << 10);
    check_tree(1 << 14);
}

static void tree_any(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 2; n <= 40; n++)
        check_tree(n);
    check_tree(999);
    check_tree(4097);
    check_tree(12345);
}

const struct kit_test kit_tests[] = {
    {"right", 3, "the sums of the right elements", right},
    {"blocks", 2, "4 roots of n steps, 3n joins", blocks},
    {"tree", 3, "2 log n steps, 2n joins, n a power of two", tree},
    {"tree-any", 2, "the same for any n", tree_any},
    {0},
};
