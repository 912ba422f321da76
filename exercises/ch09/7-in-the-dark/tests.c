// Tests of the k smallest, found without looking: which they are, their
// order, and how many operations it took.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>
#include <string.h>

struct key {
    uint32_t value;
};

// The keys of an input in their order, and one more that is nothing().
static struct key *keys;
static uint32_t count;

// What the student's process leaves behind.
static struct notes {
    uint64_t operations;
    bool no_key;
} * notes;

static bool is_key(const struct key *key)
{
    uintptr_t at = (uintptr_t)key, first = (uintptr_t)keys;
    return at >= first && at <= (uintptr_t)(keys + count) &&
           (at - first) % sizeof *key == 0;
}

static void note(const struct key *a, const struct key *b)
{
    notes->operations++;
    if (is_key(a) && is_key(b))
        return;
    notes->no_key = true;
    kit_leave();
}

const struct key *least(const struct key *a, const struct key *b)
{
    note(a, b);
    return a->value < b->value ? a : b;
}

const struct key *most(const struct key *a, const struct key *b)
{
    note(a, b);
    return a->value < b->value ? b : a;
}

const struct key *nothing(void)
{
    return keys + count;
}

// ---- inputs and answers --------------------------------------------

static const struct key **input, **kept, **right;

static int compare(const void *a, const void *b)
{
    uint32_t x = (*(const struct key *const *)a)->value;
    uint32_t y = (*(const struct key *const *)b)->value;
    return (x > y) - (x < y);
}

static void prepare(uint32_t n, uint32_t k, uint64_t seed)
{
    struct random random = {seed + n};
    count = n;
    keys = kit_input("keys", n + 1, sizeof *keys);
    input = kit_input("key", n, sizeof *input);
    kept = kit_output("kept", k, sizeof *kept);
    right = kit_input("right", n + k, sizeof *right);
    for (uint32_t i = 0; i < n; i++)
        keys[i].value = i;
    keys[n].value = UINT32_MAX;
    for (uint32_t i = n; i > 1; i--) {
        uint32_t other = random_bits(&random) % i;
        struct key key = keys[i - 1];
        keys[i - 1] = keys[other];
        keys[other] = key;
    }
    for (uint32_t i = 0; i < n + k; i++)
        right[i] = keys + (i < n ? i : n);
    memcpy(input, right, n * sizeof *input);
    qsort(right, n, sizeof *right, compare);
    kit_given("%u keys, k = %u", n, k);
}

static const char *tell(const struct key *key)
{
    if (!is_key(key))
        return "no key";
    if (key == keys + count)
        return "nothing()";
    return kit_text("key[%u], of rank %u", (unsigned)(key - keys),
                    key->value);
}

static uint32_t times(const struct key *key, uint32_t k)
{
    uint32_t n = 0;
    for (uint32_t i = 0; i < k; i++)
        n += kept[i] == key;
    return n;
}

static const char *wrong_cause(uint32_t k, uint32_t i)
{
    const struct key *found = kept[i];
    if (!is_key(found))
        return "Everything that is kept is one of the keys or "
               "nothing().";
    if (found != keys + count && times(found, k) > 1)
        return "It is kept more than once. Of two keys, one "
               "place gets the least of them and the other the most.";
    bool all = true;
    for (uint32_t r = 0; r < k && right[r] != keys + count; r++)
        all = all && times(right[r], k) == 1;
    if (all)
        return "The k smallest are all there, but not in order.";
    if (times(right[i], k) > 0)
        return "The right one is in another place, and another one was "
               "lost.";
    return "The right one was lost. What has to leave its place is "
           "compared with the next one.";
}

static void check(uint32_t k)
{
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){0};
    CALL(STUDENT(keep_smallest)(count, input, k, kept));
    if (notes->no_key)
        WRONG(.expected = "two keys to compare",
              .found = "something else",
              .cause = "A place that was never written to holds no "
                       "key. Begin with nothing() everywhere.");
    for (uint32_t i = 0; i < k; i++)
        if (kept[i] != right[i])
            WRONG(.where = kit_text("kept[%u]", i),
                  .expected = tell(right[i]), .found = tell(kept[i]),
                  .cause = wrong_cause(k, i));
}

static void check_operations(uint32_t k, uint64_t most_operations,
                             const char *cause)
{
    check(k);
    if (notes->operations > most_operations)
        WRONG(.expected = kit_text("at most %ju operations, %.3g for "
                                   "each key",
                                   (uintmax_t)most_operations,
                                   (double)most_operations / count),
              .found = kit_text("%ju, %.3g for each key",
                                (uintmax_t)notes->operations,
                                (double)notes->operations / count),
              .cause = cause);
}

// ---- tests ---------------------------------------------------------

static void two(uint64_t seed)
{
    for (uint32_t k = 1; k <= 2; k++) {
        prepare(40, k, seed);
        check(k);
        kit_next_case();
    }
}

static void any(uint64_t seed)
{
    static const uint32_t ks[] = {3, 4, 5, 7, 8, 16, 21, 32};
    for (int c = 0; c < 8; c++) {
        prepare(100 + ks[c] / 2, ks[c], seed);
        check(ks[c]);
        kit_next_case();
    }
}

static void few(uint64_t seed)
{
    for (uint32_t n = 0; n <= 8; n++) {
        prepare(n, 8, seed);
        check(8);
        kit_next_case();
        prepare(n, 3, seed);
        check(3);
        kit_next_case();
    }
}

static void operations(uint64_t seed)
{
    static const uint32_t ks[] = {1, 2, 3, 5, 8};
    for (int c = 0; c < 5; c++) {
        prepare(200, ks[c], seed);
        check_operations(ks[c], 200 * (2 * ks[c] - 1),
                         "Two for each place are enough. In the last "
                         "one, the key that has to leave is of no "
                         "interest any more.");
        kit_next_case();
    }
}

static void groups(uint64_t seed)
{
    prepare(512, 8, seed);
    check_operations(8, 10 * 512,
                     "One by one, it takes 15. Sort eight keys by "
                     "themselves, with 19 exchanges, and merge them "
                     "with those that are kept.");
}

const struct kit_test kit_tests[] = {
    {"two", 1, "the smallest, and the two smallest", two},
    {"any", 1, "k smallest for many k", any},
    {"few", 1, "hardly any keys, or none", few},
    {"operations", 4, "2k - 1 operations for a key", operations},
    {"groups", 3, "k = 8 with 10 operations for a key", groups},
    {0},
};
