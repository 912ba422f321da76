// Tests of the split and the sort, with the machine that they run on.
// It counts cycles, and it stops at the first thing that a vector
// machine could not do.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>
#include <string.h>

enum { A = 1, R = 2, S = 2, VECTORS_MOST = 1000, MOST = 1000 };

enum fault { NONE, UNKNOWN, LENGTHS, RANGE, TWICE, BIT, TOO_MANY };
static const char *const fault_causes[] = {
    [UNKNOWN] = "This vector does not come from the machine.",
    [LENGTHS] = "The vectors of an operation have the same length.",
    [RANGE] = "There are places 0 to n - 1. The ones begin behind the "
              "last zero, at the number of the zeros, n minus that of "
              "the ones.",
    [TWICE] = "Two values want one place, and one is lost. Do the ones "
              "begin behind the last zero?",
    [BIT] = "A number has the bits 0 to 31.",
    [TOO_MANY] = "Does a loop never end?",
};

// The numbers, in the student's process only, and what it leaves.
static uint32_t *stored[VECTORS_MOST];
static uint32_t names;
static struct {
    uint64_t cycles, scans; // per element
    enum fault fault;
    uint32_t value; // of which the machine complains
} * machine;

static void check(bool fine, enum fault fault, uint32_t value)
{
    if (fine)
        return;
    machine->fault = fault;
    machine->value = value;
    kit_leave();
}

static uint32_t *look_up(struct vector a)
{
    check(a.name < names, UNKNOWN, a.name);
    return stored[a.name];
}

static struct vector make(uint32_t n, int price)
{
    check(names < VECTORS_MOST, TOO_MANY, names);
    stored[names] = calloc(n + 1, sizeof(uint32_t));
    machine->cycles += price;
    return (struct vector){n, names++};
}

struct vector constant(uint32_t n, uint32_t value)
{
    struct vector result = make(n, 0);
    for (uint32_t i = 0; i < n; i++)
        stored[result.name][i] = value;
    return result;
}

struct vector numbers(uint32_t n)
{
    struct vector result = make(n, 0);
    for (uint32_t i = 0; i < n; i++)
        stored[result.name][i] = i;
    return result;
}

struct vector choose(struct vector flags, struct vector a,
                     struct vector b)
{
    uint32_t *f = look_up(flags), *one = look_up(a), *zero = look_up(b);
    check(a.n == flags.n, LENGTHS, a.n);
    check(b.n == flags.n, LENGTHS, b.n);
    struct vector result = make(a.n, A);
    for (uint32_t i = 0; i < a.n; i++)
        stored[result.name][i] = f[i] ? one[i] : zero[i];
    return result;
}

struct vector add(struct vector a, struct vector b)
{
    uint32_t *left = look_up(a), *right = look_up(b);
    check(a.n == b.n, LENGTHS, b.n);
    struct vector result = make(a.n, A);
    for (uint32_t i = 0; i < a.n; i++)
        stored[result.name][i] = left[i] + right[i];
    return result;
}

struct vector subtract(struct vector a, struct vector b)
{
    uint32_t *left = look_up(a), *right = look_up(b);
    check(a.n == b.n, LENGTHS, b.n);
    struct vector result = make(a.n, A);
    for (uint32_t i = 0; i < a.n; i++)
        stored[result.name][i] = left[i] - right[i];
    return result;
}

struct vector bit(struct vector a, int k)
{
    uint32_t *number = look_up(a);
    check(k >= 0 && k < 32, BIT, k);
    struct vector result = make(a.n, A);
    for (uint32_t i = 0; i < a.n; i++)
        stored[result.name][i] = number[i] >> k & 1;
    return result;
}

struct vector scatter(struct vector values, struct vector places)
{
    uint32_t *value = look_up(values), *place = look_up(places);
    check(values.n == places.n, LENGTHS, places.n);
    struct vector result = make(values.n, R);
    bool taken[MOST + 1] = {false};
    for (uint32_t i = 0; i < values.n; i++) {
        check(place[i] < values.n, RANGE, place[i]);
        check(!taken[place[i]], TWICE, place[i]);
        taken[place[i]] = true;
        stored[result.name][place[i]] = value[i];
    }
    return result;
}

struct vector gather(struct vector values, struct vector places)
{
    uint32_t *value = look_up(values), *place = look_up(places);
    struct vector result = make(places.n, R);
    for (uint32_t i = 0; i < places.n; i++) {
        check(place[i] < values.n, RANGE, place[i]);
        stored[result.name][i] = value[place[i]];
    }
    return result;
}

struct sums scan(struct vector a)
{
    uint32_t *number = look_up(a);
    struct sums sums = {.before = make(a.n, S)};
    for (uint32_t i = 0; i < a.n; i++) {
        stored[sums.before.name][i] = sums.total;
        sums.total += number[i];
    }
    machine->scans++;
    return sums;
}

// ---- calling the student -------------------------------------------

static struct vector load(const uint32_t *from, uint32_t n)
{
    struct vector vector = make(n, 0);
    memcpy(stored[vector.name], from, n * sizeof *from);
    return vector;
}

static void store(struct vector vector, uint32_t n, uint32_t *to)
{
    uint32_t *from = look_up(vector);
    check(vector.n == n, LENGTHS, vector.n);
    memcpy(to, from, n * sizeof *to);
}

static const char *fault_text(void)
{
    uint32_t value = machine->value;
    switch (machine->fault) {
    case RANGE:
        return kit_text("a route to place %d", (int)value);
    case TWICE:
        return kit_text("a scatter with two values for place %u",
                        value);
    case LENGTHS:
        return kit_text("a vector of length %u among others", value);
    case BIT:
        return kit_text("bit %d", (int)value);
    case TOO_MANY:
        return kit_text("%u vectors", value);
    default:
        return kit_text("a vector with the name %u", value);
    }
}

static void report_fault(uint32_t n)
{
    if (machine->fault != NONE)
        WRONG(.expected = kit_text("operations on vectors of %u", n),
              .found = fault_text(),
              .cause = fault_causes[machine->fault]);
}

static uint32_t *new_output(uint32_t n)
{
    machine = kit_output("the machine's record", 1, sizeof *machine);
    memset(machine, 0, sizeof *machine);
    return kit_output("the result", n, sizeof(uint32_t));
}

// ---- the split -----------------------------------------------------

// Takes the places from other lists of the values, for each flag in
// their order or turned round.
static void rearrange(uint32_t n, const uint32_t *values,
                      const uint32_t *flags, bool ones_first,
                      bool ones_reversed, uint32_t *result)
{
    uint32_t next = 0;
    for (int turn = 0; turn < 2; turn++) {
        uint32_t flag = turn != ones_first;
        for (uint32_t t = 0; t < n; t++) {
            uint32_t i = flag && ones_reversed ? n - 1 - t : t;
            if (flags[i] == flag)
                result[next++] = values[i];
        }
    }
}

static void gather_instead(uint32_t n, const uint32_t *values,
                           const uint32_t *flags, uint32_t *result)
{
    uint32_t ones = 0, zeros = 0, all_zeros = 0;
    for (uint32_t i = 0; i < n; i++)
        all_zeros += !flags[i];
    for (uint32_t i = 0; i < n; i++)
        result[i] = values[flags[i] ? all_zeros + ones++ : zeros++];
}

static const char *split_cause(uint32_t n, const uint32_t *values,
                               const uint32_t *flags,
                               const uint32_t *found)
{
    static uint32_t result[MOST];
    size_t bytes = n * sizeof *result;
    if (memcmp(found, values, bytes) == 0)
        return "Nothing has moved.";
    rearrange(n, values, flags, true, false, result);
    if (memcmp(found, result, bytes) == 0)
        return "The ones come first. Zeros first is asked for.";
    rearrange(n, values, flags, false, true, result);
    if (memcmp(found, result, bytes) == 0)
        return "The ones come in reverse. A split that changes their "
               "order is not stable, and no sort can be made of it.";
    gather_instead(n, values, flags, result);
    if (memcmp(found, result, bytes) == 0)
        return "The places are right, but they say where a value goes, "
               "not where it comes from: scatter, not gather.";
    return "Take the flags 1 0 0 1 0 on paper: which place does each "
           "value go to?";
}

static void check_split(uint32_t n, const uint32_t *flags)
{
    static uint32_t values[MOST], right[MOST];
    for (uint32_t i = 0; i < n; i++)
        values[i] = i + 1;
    rearrange(n, values, flags, false, false, right);
    uint32_t *found = new_output(n);
    names = 0;
    CALL(store(STUDENT(split)(load(values, n), load(flags, n)), n,
               found));
    report_fault(n);
    for (uint32_t i = 0; i < n; i++)
        if (found[i] != right[i])
            WRONG(.where = kit_text("place %u of %u", i, n),
                  .expected = kit_text("value %u, its flag is %u",
                                       right[i], flags[right[i] - 1]),
                  .found = kit_text("%u", found[i]),
                  .cause = split_cause(n, values, flags, found));
}

static void split_random(uint32_t n, double share, uint64_t seed)
{
    static uint32_t flags[MOST];
    struct random random = {seed + n};
    for (uint32_t i = 0; i < n; i++)
        flags[i] = random_uniform(&random) < share;
    kit_given("%u values 1, 2, 3, ..., flags 1 with probability %g", n,
              share);
    check_split(n, flags);
}

static void splits(uint64_t seed)
{
    for (uint32_t n = 2; n <= 40; n++) {
        split_random(n, 0.5, seed);
        kit_next_case();
    }
    split_random(MOST - 1, 0.3, seed);
}

static void one_sided(uint64_t seed)
{
    for (uint32_t n = 0; n <= 33; n += n < 3 ? 1 : 10)
        for (int flag = 0; flag <= 1; flag++) {
            split_random(n, flag, seed);
            kit_next_case();
        }
}

static const char *split_price_cause(void)
{
    if (machine->scans > 1)
        return "One scan will do. There are i values before value i. "
               "If you know how many of them are ones, you know how "
               "many are zeros.";
    return "One scan, one route and three elementwise operations will "
           "do. Are the flags turned round first? Scan them as they "
           "are.";
}

static void check_split_price(uint64_t seed, uint64_t most)
{
    split_random(500, 0.5, seed);
    if (machine->cycles > most)
        WRONG(.expected = kit_text("at most %ju cycles an element",
                                   (uintmax_t)most),
              .found = kit_text("%ju, with %ju scans",
                                (uintmax_t)machine->cycles,
                                (uintmax_t)machine->scans),
              .cause = split_price_cause());
}

static void one_scan(uint64_t seed)
{
    check_split_price(seed, 8);
}

static void seven_cycles(uint64_t seed)
{
    check_split_price(seed, 7);
}

// ---- the sort ------------------------------------------------------

static int rising(const void *a, const void *b)
{
    const uint32_t *left = a, *right = b;
    return (*left > *right) - (*left < *right);
}

// Stable splits by some of the bits, from one to another.
static void sort_by_bits(uint32_t n, const uint32_t *keys, int from,
                         int to, int step, uint32_t *result)
{
    static uint32_t before[MOST], flags[MOST];
    memcpy(result, keys, n * sizeof *result);
    for (int k = from; k != to; k += step) {
        memcpy(before, result, n * sizeof *result);
        for (uint32_t i = 0; i < n; i++)
            flags[i] = before[i] >> k & 1;
        rearrange(n, before, flags, false, false, result);
    }
}

static const char *sort_cause(uint32_t n, const uint32_t *keys,
                              int bits, const uint32_t *found)
{
    static uint32_t result[MOST];
    size_t bytes = n * sizeof *result;
    sort_by_bits(n, keys, bits - 1, -1, -1, result);
    if (memcmp(found, result, bytes) == 0)
        return "The highest bit was split first. What is split last "
               "decides most, so begin with the lowest bit.";
    sort_by_bits(n, keys, 0, bits - 1, 1, result);
    if (memcmp(found, result, bytes) == 0)
        return "The highest bit was left out: there are bits 0 to "
               "bits - 1.";
    sort_by_bits(n, keys, 1, bits, 1, result);
    if (memcmp(found, result, bytes) == 0)
        return "The lowest bit was left out: it is bit 0.";
    return "Does every split go on with what the one before it left, "
           "keys and bits alike? And is the split stable?";
}

static void check_sort(uint32_t n, const uint32_t *keys, int bits)
{
    static uint32_t right[MOST];
    kit_given("%u keys of %d bits", n, bits);
    memcpy(right, keys, n * sizeof *right);
    qsort(right, n, sizeof *right, rising);
    uint32_t *found = new_output(n);
    names = 0;
    CALL(store(STUDENT(sort)(load(keys, n), bits), n, found));
    report_fault(n);
    for (uint32_t i = 0; i < n; i++)
        if (found[i] != right[i])
            WRONG(.where = kit_text("place %u of %u", i, n),
                  .expected = kit_text("the key %u", right[i]),
                  .found = kit_text("%u", found[i]),
                  .cause = sort_cause(n, keys, bits, found));
}

static void sort_random(uint32_t n, int bits, uint64_t seed)
{
    static uint32_t keys[MOST];
    struct random random = {seed + n};
    for (uint32_t i = 0; i < n; i++)
        keys[i] = random_bits(&random) & ((UINT64_C(1) << bits) - 1);
    check_sort(n, keys, bits);
}

static void sorts(uint64_t seed)
{
    for (int bits = 2; bits <= 32; bits += 5) {
        sort_random(MOST / bits, bits, seed);
        kit_next_case();
    }
    for (uint32_t n = 0; n <= 20; n++) {
        sort_random(n, 6, seed);
        kit_next_case();
    }
}

static void sort_price(uint64_t seed)
{
    const int bits = 16;
    sort_random(300, bits, seed);
    uint64_t most = 8 * bits;
    if (machine->cycles > most)
        WRONG(.expected =
                  kit_text("at most %ju cycles a key", (uintmax_t)most),
              .found = kit_text("%ju, with %ju scans",
                                (uintmax_t)machine->cycles,
                                (uintmax_t)machine->scans),
              .cause = "A split takes 7 cycles and finding its bit "
                       "takes one. Is there more in the loop, or does "
                       "the split cost more?");
}

const struct kit_test kit_tests[] = {
    {"one-sided", 1, "no values, one, all flags equal", one_sided},
    {"split", 1, "zeros first, each side in its order", splits},
    {"one-scan", 3, "a split for at most 8 cycles", one_scan},
    {"seven", 1, "a split for at most 7 cycles", seven_cycles},
    {"sort", 2, "keys in increasing order", sorts},
    {"sort-price", 2, "a sort for 8 cycles a bit", sort_price},
    {0},
};
