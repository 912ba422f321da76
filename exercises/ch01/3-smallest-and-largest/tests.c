// Tests of the extremes: answers, and the number of comparisons.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"

// What the student's process asks, and where it leaves its count.
static const double *values;
static uint32_t value_count;
static struct {
    uint64_t comparisons;
    uint32_t invalid; // an index asked for that is none
} * asked;

bool less(uint32_t i, uint32_t j)
{
    asked->comparisons++;
    if (i >= value_count || j >= value_count) {
        asked->invalid = i >= value_count ? i : j;
        return false;
    }
    return values[i] < values[j];
}

static const char *tell(uint32_t i)
{
    if (i >= value_count)
        return kit_text("%u, which is no value's index", i);
    return kit_text("value %u, which is %.9g", i, values[i]);
}

static const char *cause(uint32_t right, uint32_t found, bool largest)
{
    if (found >= value_count)
        return "Is the answer set even if no comparison says yes?";
    if (largest && value_count > 2) {
        uint32_t smallest = 0;
        for (uint32_t i = 1; i < value_count; i++)
            if (values[i] < values[smallest])
                smallest = i;
        if (values[found] == values[smallest])
            return "This is the smallest. Is the comparison the wrong "
                   "way round, or the largest never replaced?";
    }
    if (value_count % 2 && right == value_count - 1)
        return "If n is odd, one value is left without a partner: it "
               "was never looked at.";
    return "It was passed over. A pair of values can replace both, the "
           "smallest and the largest: no else between the two.";
}

static void ask(double *given, uint32_t n)
{
    values = given;
    value_count = n;
    asked = kit_output("the count", 1, sizeof *asked);
    asked->comparisons = 0;
    asked->invalid = 0;
    struct extremes *found = kit_output("the answer", 1, sizeof *found);
    CALL(*found = STUDENT(find_extremes)(n));
    if (asked->invalid >= n)
        WRONG(.expected = kit_text("indices below %u", n),
              .found =
                  kit_text("less() is asked about %u", asked->invalid),
              .cause = "At this index there is no value. If n is odd, "
                       "the last one has no partner.");
    uint32_t low = 0, high = 0;
    for (uint32_t i = 1; i < n; i++) {
        if (values[i] < values[low])
            low = i;
        if (values[i] > values[high])
            high = i;
    }
    if (found->smallest >= n || values[found->smallest] != values[low])
        WRONG(.where = "the smallest", .expected = tell(low),
              .found = tell(found->smallest),
              .cause = cause(low, found->smallest, false));
    if (found->largest >= n || values[found->largest] != values[high])
        WRONG(.where = "the largest", .expected = tell(high),
              .found = tell(found->largest),
              .cause = cause(high, found->largest, true));
}

static void ask_random(uint32_t n, uint64_t seed)
{
    struct random random = {seed + n};
    double *given = kit_input("the values", n, sizeof *given);
    for (uint32_t i = 0; i < n; i++)
        given[i] = random_uniform(&random);
    kit_given("%u random values", n);
    ask(given, n);
}

static void few(uint64_t seed)
{
    for (uint32_t n = 1; n <= 12; n++) {
        ask_random(n, seed);
        kit_next_case();
    }
}

static void in_order(uint64_t seed)
{
    (void)seed;
    for (int falling = 0; falling < 2; falling++)
        for (uint32_t n = 50; n <= 51; n++) {
            double *given = kit_input("the values", n, sizeof *given);
            for (uint32_t i = 0; i < n; i++)
                given[i] = falling ? n - i : i;
            kit_given("%u values, %s", n,
                      falling ? "falling" : "rising");
            ask(given, n);
            kit_next_case();
        }
}

static void equal(uint64_t seed)
{
    (void)seed;
    double *given = kit_input("the values", 9, sizeof *given);
    for (uint32_t i = 0; i < 9; i++)
        given[i] = 5;
    kit_given("9 values, all equal");
    ask(given, 9);
}

// Both extremes in one pair, wherever it is.
static void side_by_side(uint64_t seed)
{
    (void)seed;
    const uint32_t n = 8;
    for (uint32_t i = 0; i + 1 < n; i++) {
        double *given = kit_input("the values", n, sizeof *given);
        for (uint32_t j = 0; j < n; j++)
            given[j] = 0.5;
        given[i] = 0;
        given[i + 1] = 1;
        kit_given("8 values, the extremes at %u and %u", i, i + 1);
        ask(given, n);
        kit_next_case();
    }
}

static void check_count(uint32_t n, uint64_t seed, uint64_t most)
{
    ask_random(n, seed);
    if (asked->comparisons > most)
        WRONG(.expected =
                  kit_text("at most %ju comparisons", (uintmax_t)most),
              .found = kit_text("%ju", (uintmax_t)asked->comparisons),
              .cause = asked->comparisons <= most + 2
                           ? "Nearly: what is compared for the first "
                             "pair, or for the value without partner, "
                             "that is known already?"
                           : "Every value is compared with both "
                             "extremes. Take two values, compare them "
                             "with each other, and then each with one "
                             "of the extremes only.");
    kit_next_case();
}

static void count_even(uint64_t seed)
{
    check_count(1000, seed, 3 * 1000 / 2 - 2);
    check_count(2, seed, 1);
}

static void count_odd(uint64_t seed)
{
    check_count(1001, seed, 3 * 1000 / 2);
    check_count(3, seed, 3);
    check_count(1, seed, 0);
}

const struct kit_test kit_tests[] = {
    {"few", 1, "1 to 12 values", few},
    {"in-order", 1, "rising and falling values", in_order},
    {"equal", 1, "values that are all equal", equal},
    {"side-by-side", 1, "both extremes in one pair", side_by_side},
    {"count-even", 3, "at most 3n/2 - 2, n even", count_even},
    {"count-odd", 3, "at most 3(n - 1)/2, n odd", count_odd},
    {0},
};
