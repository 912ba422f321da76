// Tests of the shares: that they are shares, and how many pairs the
// busiest thread has.
#include "exercise.h"
#include "kit.h"

// Pairs in the rows from i on.
static uint64_t pairs_from(uint32_t n, uint32_t i)
{
    return i == n ? 0 : (uint64_t)(n - i) * (n - i - 1) / 2;
}

static uint64_t share(uint32_t n, const uint32_t *first, int t)
{
    return pairs_from(n, first[t]) - pairs_from(n, first[t + 1]);
}

static int busiest(uint32_t n, int threads, const uint32_t *first)
{
    int busiest = 0;
    for (int t = 1; t < threads; t++)
        if (share(n, first, t) > share(n, first, busiest))
            busiest = t;
    return busiest;
}

static const char *bound_cause(uint32_t n, uint32_t found)
{
    if (found + 1 == n)
        return "The rows are counted from 0 to n - 1, and the last row "
               "is given out, too, though it has no pairs.";
    if (found == 0xa5a5a5a5)
        return "This element was never set: first has one more than "
               "there are threads.";
    return "All rows are given out: from row 0 up to, not including, "
           "row n.";
}

// Asks for a division and checks that it is one.
static const uint32_t *ask(uint32_t n, int threads)
{
    kit_given("%u rows, %d threads", n, threads);
    uint32_t *first = kit_output("first", threads + 1, sizeof *first);
    CALL(STUDENT(share_rows)(n, threads, first));
    for (int end = 0; end <= threads; end += threads) {
        uint32_t right = end == 0 ? 0 : n;
        if (first[end] != right)
            WRONG(.where = kit_text("first[%d]", end),
                  .expected = kit_text("%u", right),
                  .found = kit_text("%u", first[end]),
                  .cause = bound_cause(n, first[end]));
    }
    for (int t = 0; t < threads; t++)
        if (first[t] > first[t + 1])
            WRONG(.where = kit_text("first[%d]", t + 1),
                  .expected = kit_text("at least %u, as first[%d]",
                                       first[t], t),
                  .found = kit_text("%u", first[t + 1]),
                  .cause = "The rows are given out in order, and "
                           "none twice.");
    return first;
}

static const char *share_cause(uint32_t n, int threads,
                               const uint32_t *first, int t)
{
    bool equal_rows = true, reversed = first[1] > n / 2;
    for (int s = 0; s < threads; s++) {
        uint32_t rows = first[s + 1] - first[s];
        equal_rows &= rows <= n / threads + 1;
        reversed &= s == 0 || rows <= first[s] - first[s - 1] + 1;
    }
    if (equal_rows)
        return "Every thread has as many rows, but the rows become "
               "shorter: share the pairs, not the rows.";
    if (reversed)
        return "The long rows come first: the rows become shorter, "
               "and row i has n - 1 - i pairs.";
    if (n > 65536 && share(n, first, threads - 1) == share(n, first, t))
        return "The last thread gets all that is left. Is the number "
               "of all pairs computed in 32 bits?";
    if (t == threads - 1)
        return "What the others take too little is left to the last "
               "thread: let the sums of the shares come out right, "
               "not each share by itself.";
    return "Does every thread stop when its share, and those of the "
           "threads before it, are done?";
}

static void check_share(uint32_t n, int threads, uint64_t most,
                        const char *means)
{
    const uint32_t *first = ask(n, threads);
    int t = busiest(n, threads, first);
    uint64_t found = share(n, first, t);
    if (found > most)
        WRONG(.where = kit_text("thread %d, rows %u to %u", t, first[t],
                                first[t + 1] - 1),
              .expected = kit_text("at most %ju pairs, %s",
                                   (uintmax_t)most, means),
              .found = kit_text(
                  "%ju pairs, %.2f times the mean", (uintmax_t)found,
                  (double)found * threads / pairs_from(n, 0)),
              .cause = share_cause(n, threads, first, t));
    kit_next_case();
}

static void check_half_more(uint32_t n, int threads)
{
    uint64_t mean = pairs_from(n, 0) / threads;
    check_share(n, threads, mean + mean / 2, "the mean and half of it");
}

static void check_one_row(uint32_t n, int threads)
{
    check_share(n, threads, pairs_from(n, 0) / threads + n - 1,
                "the mean and one row");
}

static void valid(uint64_t seed)
{
    (void)seed;
    for (int threads = 1; threads <= 16; threads++) {
        ask(1000, threads);
        kit_next_case();
    }
}

static void few_rows(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 2; n <= 12; n++)
        check_one_row(n, 8);
}

static void half_more(uint64_t seed)
{
    (void)seed;
    for (int threads = 2; threads <= 16; threads++)
        check_half_more(1000, threads);
}

static void one_row(uint64_t seed)
{
    (void)seed;
    for (int threads = 2; threads <= 16; threads++)
        check_one_row(1000, threads);
    check_one_row(200, 60);
}

static void many_rows(uint64_t seed)
{
    (void)seed;
    check_one_row(100000, 2);
    check_one_row(100000, 10);
}

const struct kit_test kit_tests[] = {
    {"valid", 2, "all rows are given out, in order", valid},
    {"few-rows", 1, "more threads than rows", few_rows},
    {"half-more", 2, "at most half more than the mean", half_more},
    {"one-row", 3, "at most the mean and one row", one_row},
    {"many-rows", 2, "the same for 100,000 rows", many_rows},
    {0},
};
