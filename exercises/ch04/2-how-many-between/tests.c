// Tests of the counts between two bounds: against a count of all the
// numbers, and the looks against what the two bins hold.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

// A question, and what the student's process noted while it answered.
struct query {
    double a, b;
};
struct notes {
    uint32_t answer, looks;
    uint32_t outside; // calls of bin_of for no bin
    uint32_t nowhere; // calls of look for no place
};

static struct bins bins;
static double *numbers; // sorted by bin
static struct query *queries;
static uint32_t query_count;
static struct notes *notes;
static uint32_t asked; // the query that is being answered

static uint32_t find_bin(double x)
{
    uint32_t k = bins.count - 1;
    while (k > 0 && x < bins.border[k])
        k--;
    return k;
}

static bool in_bins(double x)
{
    return x >= bins.border[0] && x <= bins.border[bins.count];
}

uint32_t bin_of(const struct bins *unused, double x)
{
    (void)unused;
    notes[asked].outside += !in_bins(x);
    return find_bin(x);
}

double look(uint32_t place)
{
    notes[asked].looks++;
    if (place < bins.start[bins.count])
        return numbers[place];
    notes[asked].nowhere++;
    return 0;
}

// Sorts n numbers into bins of equal width from low to high, the lowest
// index first.
static void prepare(const double *unsorted, uint32_t n, double low,
                    double high, uint32_t count)
{
    double *border = kit_input("border", count + 1, sizeof *border);
    uint32_t *start = kit_input("start", count + 1, sizeof *start);
    for (uint32_t k = 0; k <= count; k++)
        border[k] = low + (high - low) * k / count;
    bins = (struct bins){count, border, start};
    numbers = kit_input("the numbers", n, sizeof *numbers);
    uint32_t placed = 0;
    for (uint32_t k = 0; k < count; k++) {
        start[k] = placed;
        for (uint32_t i = 0; i < n; i++)
            if (find_bin(unsorted[i]) == k)
                numbers[placed++] = unsorted[i];
    }
    start[count] = placed;
    queries = kit_input("the questions", 1000, sizeof *queries);
    query_count = 0;
}

static void ask(double a, double b)
{
    queries[query_count++] = (struct query){a, b};
}

// The right answer, and those of likely mistakes: which bounds belong
// to the interval, and which of the two bins is taken as a whole.
enum rule {
    RIGHT,
    CLOSED,
    OPEN,
    OTHER_HALF,
    BINS_BETWEEN,
    BINS_THROUGH,
    RULES
};

static uint32_t answer_by(enum rule rule, struct query q)
{
    if (rule == BINS_BETWEEN || rule == BINS_THROUGH)
        return bins.start[find_bin(q.b) + (rule == BINS_THROUGH)] -
               bins.start[find_bin(q.a)];
    uint32_t found = 0;
    for (uint32_t s = 0; s < bins.start[bins.count]; s++) {
        double x = numbers[s];
        bool with_a = rule == RIGHT || rule == CLOSED;
        bool with_b = rule == CLOSED || rule == OTHER_HALF;
        found += (with_a ? x >= q.a : x > q.a) &&
                 (with_b ? x <= q.b : x < q.b);
    }
    return found;
}

// The rule that explains more than half of the wrong answers, or RIGHT
// if there is none.
static enum rule rule_followed(void)
{
    uint32_t wrong = 0, explained[RULES] = {0};
    for (uint32_t k = 0; k < query_count; k++) {
        struct query q = queries[k];
        if (notes[k].answer == answer_by(RIGHT, q))
            continue;
        wrong++;
        for (enum rule rule = CLOSED; rule < RULES; rule++)
            explained[rule] += notes[k].answer == answer_by(rule, q);
    }
    enum rule best = RIGHT;
    for (enum rule rule = CLOSED; rule < RULES; rule++)
        if (explained[rule] > explained[best])
            best = rule;
    return 2 * explained[best] > wrong ? best : RIGHT;
}

// Looks that one bound is worth.
static uint32_t worth(double x, bool free_borders)
{
    uint32_t k = find_bin(x);
    if (!in_bins(x) || (free_borders && x == bins.border[k]))
        return 0;
    return bins.start[k + 1] - bins.start[k];
}

static const char *tell(struct query q)
{
    return kit_text("a = %.17g, b = %.17g", q.a, q.b);
}

static const char *wrong_cause(struct query q, uint32_t found)
{
    if (!(q.a < q.b))
        return "Nothing lies between: an interval that ends where it "
               "begins, or before, is empty, and a difference of "
               "unsigned numbers cannot be negative.";
    switch (rule_followed()) {
    case CLOSED:
        return "A number that equals b was counted: the interval ends "
               "before b.";
    case OPEN:
        return "A number that equals a was left out: the interval "
               "begins with a.";
    case OTHER_HALF:
        return "Of the two bounds a belongs to the interval and b does "
               "not: here it is the other way round.";
    case BINS_BETWEEN:
    case BINS_THROUGH:
        return "These are whole bins. Some of the numbers in the bins "
               "of a and b lie between, and some do not: look.";
    default:
        break;
    }
    if (found > bins.start[bins.count])
        return "That is more than there are numbers. Was something "
               "subtracted from less?";
    if (find_bin(q.a) == find_bin(q.b))
        return "Both bounds lie in one bin: is every number in it "
               "compared with both?";
    return "All numbers in the bins between those of a and b count, "
           "and in these two only some.";
}

static void check_answers(void)
{
    notes = kit_output("the answers", query_count + 1, sizeof *notes);
    for (uint32_t q = 0; q <= query_count; q++)
        notes[q] = (struct notes){.answer = 0};
    CALL(for (asked = 0; asked < query_count; asked++) notes[asked]
             .answer = STUDENT(count_between)(&bins, queries[asked].a,
                                              queries[asked].b));
    for (uint32_t k = 0; k < query_count; k++) {
        struct query q = queries[k];
        kit_given("%u numbers in %u bins from %g to %g",
                  bins.start[bins.count], bins.count, bins.border[0],
                  bins.border[bins.count]);
        if (notes[k].outside)
            WRONG(.where = tell(q),
                  .expected = "bounds inside the bins",
                  .found = "bin_of called with a bound that is not",
                  .cause = "What lies below the lowest border or above "
                           "the highest is in no bin. Answer for these "
                           "bounds without bin_of.");
        if (notes[k].nowhere)
            WRONG(.where = tell(q), .expected = "looks at places",
                  .found = "a look at a place that holds nothing",
                  .cause = "The numbers of bin k stand from start[k] "
                           "up to, not including, start[k + 1].");
        if (notes[k].answer != answer_by(RIGHT, q))
            WRONG(.where = tell(q),
                  .expected =
                      kit_text("%u numbers", answer_by(RIGHT, q)),
                  .found = kit_text("%u", notes[k].answer),
                  .cause = wrong_cause(q, notes[k].answer));
    }
}

static void check_looks(bool free_borders)
{
    check_answers();
    for (uint32_t k = 0; k < query_count; k++) {
        struct query q = queries[k];
        uint32_t most =
            worth(q.a, free_borders) + worth(q.b, free_borders);
        if (notes[k].looks <= most)
            continue;
        uint32_t both = worth(q.a, false) + worth(q.b, false);
        WRONG(.where = tell(q),
              .expected = kit_text("at most %u looks", most),
              .found = kit_text("%u", notes[k].looks),
              .cause = notes[k].looks <= both
                           ? "A bound stands where its bin begins. "
                             "Nothing in that bin is less, so there is "
                             "nothing to look for."
                           : "Only in the bins of a and b is there a "
                             "doubt. What stands in the bins before "
                             "them is known without a look.");
    }
}

// n uniform numbers from 0 to 100.
static void uniform(uint32_t n, uint32_t count, uint64_t seed)
{
    struct random random = {seed};
    double unsorted[2000];
    for (uint32_t i = 0; i < n; i++)
        unsorted[i] = 100 * random_uniform(&random);
    prepare(unsorted, n, 0, 100, count);
}

static void ask_at_random(uint32_t questions, uint64_t seed)
{
    struct random random = {~seed};
    for (uint32_t q = 0; q < questions; q++) {
        double a = 100 * random_uniform(&random);
        double b = 100 * random_uniform(&random);
        ask(fmin(a, b), fmax(a, b));
    }
}

// Not all numbers are looked at, and not none: there is no other way to
// tell the numbers in a bin.
static void check_few_looks(void)
{
    check_answers();
    uint64_t found = 0, all = 0;
    for (uint32_t k = 0; k < query_count; k++) {
        found += notes[k].looks;
        all += bins.start[bins.count];
    }
    if (found == 0)
        WRONG(.expected = "looks at the numbers in the bins of a and b",
              .found = "none",
              .cause = "Only look() may read a number.");
    if (found > all / 4)
        WRONG(.expected = kit_text("far fewer than %u looks for a pair "
                                   "of bounds",
                                   bins.start[bins.count]),
              .found = kit_text("%.0f on average",
                                (double)found / query_count),
              .cause = "To look at all numbers is right without bins, "
                       "too. How many are in a bin is known without a "
                       "look.");
}

static void right(uint64_t seed)
{
    uniform(1000, 64, seed);
    ask_at_random(200, seed);
    check_few_looks();
}

// Numbers on all borders and between, bounds on all borders and
// between.
static void set_on_borders(void)
{
    const double unsorted[] = {4,   0, 1,   2, 3,   4, 0.5, 2,
                               2.5, 3, 1.5, 1, 3.5, 0, 2,   4};
    prepare(unsorted, 16, 0, 4, 4);
    for (int a = 0; a <= 8; a++)
        for (int b = a; b <= 8; b++)
            ask(a / 2.0, b / 2.0);
}

static void on_borders(uint64_t seed)
{
    (void)seed;
    set_on_borders();
    check_answers();
}

static void outside(uint64_t seed)
{
    uniform(50, 8, seed);
    const double bounds[] = {-INFINITY, -1e300, -5,  0,
                             40,        100,    101, INFINITY};
    for (int a = 0; a < 8; a++)
        for (int b = 0; b < 8; b++)
            ask(bounds[a], bounds[b]);
    check_answers();
}

// One bin, no numbers, all numbers in one bin or in one place.
static void odd_bins(uint64_t seed)
{
    uniform(40, 1, seed);
    ask_at_random(40, seed);
    check_answers();
    kit_next_case();
    uniform(0, 4, seed);
    ask_at_random(20, seed);
    check_answers();
    kit_next_case();
    double unsorted[30];
    for (int i = 0; i < 30; i++)
        unsorted[i] = i < 15 ? 55 : 51 + i / 10.0;
    prepare(unsorted, 30, 0, 100, 10);
    for (double a = 49; a <= 61; a += 0.5)
        for (double b = a; b <= 61; b += 0.5)
            ask(a, b);
    check_answers();
}

static void looks(uint64_t seed)
{
    uniform(2000, 100, seed);
    ask_at_random(200, seed);
    ask(-INFINITY, 50.5);
    ask(50.5, INFINITY);
    ask(-INFINITY, INFINITY);
    check_looks(false);
}

static void looks_on_borders(uint64_t seed)
{
    (void)seed;
    set_on_borders();
    check_looks(true);
}

const struct kit_test kit_tests[] = {
    {"right", 2, "1,000 numbers in 64 bins, few looks", right},
    {"on-borders", 1, "numbers and bounds on borders", on_borders},
    {"outside", 2, "bounds outside, empty intervals", outside},
    {"odd-bins", 1, "one bin, no numbers, all in one bin", odd_bins},
    {"looks", 3, "looks only in the bins of the bounds", looks},
    {"looks-on-borders", 1, "no look for a bound on a border",
     looks_on_borders},
    {0},
};
