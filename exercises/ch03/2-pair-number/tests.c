// Tests of the numbers of pairs: both directions, against counting for
// few points and, for many, at the two ends of rows.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"

static const uint32_t thousands = 100000, billions = 4000000000;

// Row i begins here. No product exceeds 64 bits.
static uint64_t begin(uint32_t n, uint32_t i)
{
    return (uint64_t)i * (2 * (uint64_t)n - i - 1) / 2;
}

static const char *number_cause(uint32_t n, struct pair pair,
                                uint64_t right, uint64_t found)
{
    if (found == (uint64_t)pair.i * n + pair.j)
        return "This is the number in a full square, in which every "
               "row has n pairs: row i has only n - 1 - i.";
    if (found >> 32 != right >> 32)
        return "A product was computed in 32 bits before it was made "
               "wider: convert first, then multiply.";
    if (found == right + 1 || found + 1 == right)
        return "Off by one: the first pair of its row has j = i + 1, "
               "and the very first number is 0.";
    return "How many pairs do all the rows before i have?";
}

static void check_number(uint32_t n, struct pair pair, uint64_t right,
                         uint64_t found)
{
    if (found != right)
        WRONG(.where = kit_text("pair (%u, %u) of %u points", pair.i,
                                pair.j, n),
              .expected = kit_text("number %ju", (uintmax_t)right),
              .found = kit_text("%ju", (uintmax_t)found),
              .cause = number_cause(n, pair, right, found));
}

static const char *pair_cause(uint32_t n, uint64_t number,
                              struct pair right, struct pair found)
{
    if (found.i == number / n && found.j == number % n)
        return "This is the pair of a full square, in which every row "
               "has n pairs.";
    if (found.i >= found.j || found.j >= n)
        return "This is no pair at all. A root was rounded into the "
               "next row, or the count of the pairs behind this one "
               "is off.";
    if (begin(n, found.i) + (found.j - found.i - 1) == number)
        return "Is the sum computed in 64 bits?";
    if (found.i + 1 == right.i || right.i + 1 == found.i)
        return "The row next to it. A root was rounded: check with "
               "integers that the row begins at or before the number, "
               "and the next one after it.";
    return "Which is the last row that begins at or before this "
           "number?";
}

static void check_pair(uint32_t n, uint64_t number, struct pair right,
                       struct pair found)
{
    if (found.i != right.i || found.j != right.j)
        WRONG(.where = kit_text("number %ju of %u points",
                                (uintmax_t)number, n),
              .expected = kit_text("(%u, %u)", right.i, right.j),
              .found = kit_text("(%u, %u)", found.i, found.j),
              .cause = pair_cause(n, number, right, found));
}

// Pairs to ask for, and their numbers.
struct list {
    uint32_t n, count;
    struct pair *pairs;
    uint64_t *numbers;
};

static struct list make_list(uint32_t n, uint32_t room)
{
    return (struct list){
        n, 0, kit_input("the pairs", room, sizeof(struct pair)),
        kit_input("the numbers", room, sizeof(uint64_t))};
}

static void add(struct list *list, uint32_t i, uint32_t j)
{
    list->pairs[list->count] = (struct pair){i, j};
    list->numbers[list->count++] = begin(list->n, i) + (j - i - 1);
}

// Every pair of few points, counted.
static struct list all_of(uint32_t n)
{
    struct list list = make_list(n, n * (n - 1) / 2);
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i + 1; j < n; j++) {
            add(&list, i, j);
            list.numbers[list.count - 1] = list.count - 1;
        }
    kit_given("all pairs of %u points", n);
    return list;
}

// First and last pair of some rows, the first and last rows included.
static struct list ends_of(uint32_t n, uint64_t seed)
{
    enum { ENDS = 1000, MIDDLE = 4000 };
    struct random random = {seed};
    struct list list = make_list(n, 2 * (2 * ENDS + MIDDLE));
    for (uint32_t r = 0; r < 2 * ENDS + MIDDLE; r++) {
        uint32_t i = r < ENDS       ? r
                     : r < 2 * ENDS ? n - 2 - (r - ENDS)
                                    : random_bits(&random) % (n - 1);
        add(&list, i, i + 1);
        add(&list, i, n - 1);
    }
    kit_given("both ends of rows, %u points", n);
    return list;
}

static void check_numbers(struct list list)
{
    uint64_t *found =
        kit_output("the answers", list.count, sizeof *found);
    CALL(for (uint32_t k = 0; k < list.count; k++) found[k] = STUDENT(
             number_of_pair)(list.n, list.pairs[k].i, list.pairs[k].j));
    for (uint32_t k = list.count; k-- > 0;)
        check_number(list.n, list.pairs[k], list.numbers[k], found[k]);
    kit_next_case();
}

static void check_pairs(struct list list)
{
    struct pair *found =
        kit_output("the answers", list.count, sizeof *found);
    CALL(for (uint32_t k = 0; k < list.count; k++) found[k] =
             STUDENT(pair_of_number)(list.n, list.numbers[k]));
    for (uint32_t k = list.count; k-- > 0;)
        check_pair(list.n, list.numbers[k], list.pairs[k], found[k]);
    kit_next_case();
}

// The same calls for many points and for few: a walk from row to row
// takes dozens of times as long for many.
static void check_walk(uint64_t seed)
{
    const double most = 8, least = 20e-3; // times; seconds
    check_pairs(ends_of(thousands / 40, seed));
    double few = kit_seconds(false);
    check_pairs(ends_of(thousands, seed));
    double many = kit_seconds(false);
    if (many > most * few + least && !kit_is_sanitized())
        WRONG(.where = "the time of pair_of_number",
              .expected = "as much for a hundred thousand points as "
                          "for a few thousand",
              .found = kit_text("%.0f times as much", many / few),
              .cause = "A walk from row to row takes a time that grows "
                       "with n. Which row a number is in can be "
                       "computed.");
}

static void number_few(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 30; n >= 2; n--)
        check_numbers(all_of(n));
}

static void number_many(uint64_t seed)
{
    check_numbers(ends_of(thousands, seed));
}

static void pair_few(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 30; n >= 2; n--)
        check_pairs(all_of(n));
}

static void pair_many(uint64_t seed)
{
    check_walk(seed);
}

static void billions_of_points(uint64_t seed)
{
    check_walk(seed);
    check_numbers(ends_of(billions, seed));
    kit_if_endless("A walk from row to row, or a loop that corrects a "
                   "guess far from the row: eight times the number of "
                   "a pair does not fit into 64 bits. Multiply as "
                   "double.");
    check_pairs(ends_of(billions, seed));
}

const struct kit_test kit_tests[] = {
    {"number-few", 1, "numbers of pairs, few points", number_few},
    {"number-many", 2, "numbers, a hundred thousand points",
     number_many},
    {"pair-few", 1, "pairs of numbers, few points", pair_few},
    {"pair-many", 3, "pairs, in a time that does not grow", pair_many},
    {"billions", 3, "both, four billion points", billions_of_points},
    {0},
};
