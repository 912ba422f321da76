// Tests of the radix sort: order, the order of equal keys, and the
// calls, against one reading for all histograms and one pass for every
// byte in which the keys differ.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

enum { BYTES = 4 };

// The arrays and the notes, in the student's process.
static struct record *arrays[2];
static uint32_t record_count;
static struct notes {
    uint64_t gets, puts;
    bool invalid; // an access that was refused, and where
    int array;
    uint32_t place;
} * notes;

static bool valid(int array, uint32_t i)
{
    if ((array == 0 || array == 1) && i < record_count)
        return true;
    if (!notes->invalid) {
        notes->invalid = true;
        notes->array = array;
        notes->place = i;
    }
    return false;
}

struct record get(int array, uint32_t i)
{
    notes->gets++;
    return valid(array, i) ? arrays[array][i] : (struct record){0};
}

void put(int array, uint32_t i, struct record record)
{
    notes->puts++;
    if (valid(array, i))
        arrays[array][i] = record;
}

static const struct record *prepare(uint32_t n)
{
    record_count = n;
    arrays[0] = kit_output("array 0", n, sizeof(struct record));
    arrays[1] = kit_output("array 1", n, sizeof(struct record));
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){0};
    return kit_input("the records", n, sizeof(struct record));
}

// Records with random bits where the mask has ones, and the others as
// in the pattern.
static const struct record *draw(uint32_t n, uint32_t mask,
                                 uint32_t pattern, uint64_t seed)
{
    struct record *records = (struct record *)prepare(n);
    struct random random = {seed};
    for (uint32_t i = 0; i < n; i++) {
        uint32_t bits = (uint32_t)random_bits(&random);
        records[i] = (struct record){(bits & mask) | pattern, i};
    }
    memcpy(arrays[0], records, n * sizeof *records);
    kit_given("%u records, keys 0x%08x with random bits in 0x%08x", n,
              pattern, mask);
    return records;
}

// What several sorts would answer: by some bytes only, from the
// highest byte down, with every pass backward.
enum rule { STRAIGHT, HIGHEST_FIRST, BACKWARD };

static void sort_by(struct record *records, uint32_t n, int byte,
                    bool backward)
{
    struct record *copy = kit_input("a copy", n, sizeof *copy);
    memcpy(copy, records, n * sizeof *copy);
    uint32_t to = 0;
    for (uint32_t value = 0; value < 256; value++)
        for (uint32_t k = 0; k < n; k++) {
            uint32_t i = backward ? n - 1 - k : k;
            if ((copy[i].key >> 8 * byte & 0xff) == value)
                records[to++] = copy[i];
        }
}

// Sorted by the bytes from low up to, not including, high.
static struct record *sorted(const struct record *records, uint32_t n,
                             int low, int high, enum rule rule)
{
    struct record *sorted = kit_input("a copy", n, sizeof *sorted);
    memcpy(sorted, records, n * sizeof *sorted);
    for (int b = low; b < high; b++)
        sort_by(sorted, n, rule == HIGHEST_FIRST ? BYTES - 1 - b : b,
                rule == BACKWARD);
    return sorted;
}

static bool same(const struct record *a, const struct record *b,
                 uint32_t n)
{
    return memcmp(a, b, n * sizeof *a) == 0;
}

static bool complete(const struct record *found, uint32_t n)
{
    bool *there = kit_input("who is there", n, sizeof *there);
    memset(there, false, n);
    for (uint32_t i = 0; i < n; i++) {
        if (found[i].point >= n || there[found[i].point])
            return false;
        there[found[i].point] = true;
    }
    return true;
}

static const char *order_cause(const struct record *records, uint32_t n,
                               int answer)
{
    const struct record *found = arrays[answer];
    const struct record *right = sorted(records, n, 0, BYTES, STRAIGHT);
    if (same(arrays[1 - answer], right, n))
        return kit_text(
            "The sorted records are in array %d. It depends "
            "on the number of passes where they end.",
            1 - answer);
    if (same(found, records, n))
        return "The records are in the order in which they came.";
    if (!complete(found, n))
        return "Not every record is there. Two were put into the same "
               "place, or this array was not written to the end.";
    if (same(found, sorted(records, n, 0, BYTES, HIGHEST_FIRST), n))
        return "The last pass decides, so it must be the one for the "
               "highest byte: begin with the lowest.";
    if (same(found, sorted(records, n, 0, BYTES, BACKWARD), n))
        return "Every pass turns the order of equal bytes around, and "
               "undoes what the one before did: read the records from "
               "the first to the last.";
    for (int high = 1; high < BYTES; high++)
        if (same(found, sorted(records, n, 0, high, STRAIGHT), n))
            return kit_text("They are sorted by the lower bytes only. "
                            "Byte %d, counted from 0, plays no part.",
                            high);
    for (int b = 1; b < BYTES; b++)
        if (same(found, sorted(records, n, b, b + 1, STRAIGHT), n))
            return "They are sorted by one byte only: does each pass "
                   "read what the pass before it wrote?";
    for (uint32_t i = 1; i < n; i++)
        if (found[i - 1].key > found[i].key)
            return "Does every pass keep the order of records with "
                   "equal bytes, and do the starts of a byte come from "
                   "its own counts?";
    return "The keys are in order, but those with equal keys are not "
           "as they were.";
}

static const char *tell(struct record record)
{
    return kit_text("key 0x%08x of point %u", record.key, record.point);
}

static void check(const struct record *records)
{
    uint32_t n = record_count;
    int *answer = kit_output("the answer", 1, sizeof *answer);
    CALL(*answer = STUDENT(sort_records)(n));
    if (notes->invalid)
        WRONG(.found = kit_text("element %u of array %d", notes->place,
                                notes->array),
              .expected = kit_text("elements below %u of arrays 0 "
                                   "and 1",
                                   n),
              .cause = "There is no such element. The first place of a "
                       "byte is the number of records before it; its "
                       "own do not count.");
    if (*answer != 0 && *answer != 1)
        WRONG(.expected = "array 0 or 1",
              .found = kit_text("%d", *answer),
              .cause = "The answer is the array in which the sorted "
                       "records are.");
    const struct record *found = arrays[*answer];
    const struct record *right = sorted(records, n, 0, BYTES, STRAIGHT);
    for (uint32_t i = 0; i < n; i++)
        if (!same(&found[i], &right[i], 1))
            WRONG(.where =
                      kit_text("element %u of array %d", i, *answer),
                  .expected = tell(right[i]), .found = tell(found[i]),
                  .cause = order_cause(records, n, *answer));
}

// Bytes in which not all keys agree; in which not all are 0.
static void count_bytes(const struct record *records, uint32_t n,
                        uint32_t *differ, uint32_t *not_zero)
{
    *differ = *not_zero = 0;
    for (int b = 0; b < BYTES; b++) {
        uint32_t differences = 0, ones = 0;
        for (uint32_t i = 0; i < n; i++) {
            uint32_t byte = records[i].key >> 8 * b & 0xff;
            differences |= byte ^ (records[0].key >> 8 * b & 0xff);
            ones |= byte;
        }
        *differ += differences != 0;
        *not_zero += ones != 0;
    }
}

static const char *puts_cause(const struct record *records, uint32_t n)
{
    uint32_t p, not_zero;
    count_bytes(records, n, &p, &not_zero);
    if (notes->puts < (uint64_t)p * n)
        return "That is too few for 256 counts a pass: the records "
               "were "
               "sorted somewhere else.";
    if (notes->puts == (uint64_t)not_zero * n)
        return "Are bytes passed over only if they are 0? All keys may "
               "agree in another value.";
    if (notes->puts == BYTES * n)
        return "A pass over a byte in which all keys agree moves every "
               "record and changes nothing: leave it out.";
    if (notes->puts == (uint64_t)(p + 1) * n)
        return "Is the result copied once more at the end? The answer "
               "may be either array.";
    return "A record needs to be put once for every byte in which the "
           "keys differ.";
}

static const char *gets_cause(uint32_t n, uint32_t p)
{
    uint64_t readings = notes->gets / n;
    if (readings == 2 * p || readings == 2 * p + 1 ||
        readings == 2 * BYTES)
        return "Every pass reads the records once more to count them. "
               "The counts do not depend on the order: one reading "
               "counts all four bytes.";
    if (readings == p + BYTES)
        return "There is a reading for each histogram: one reading "
               "counts all four bytes.";
    return "One reading counts, and one for each pass places.";
}

static void check_calls(const struct record *records)
{
    check(records);
    uint32_t n = record_count, p, not_zero;
    count_bytes(records, n, &p, &not_zero);
    if (notes->puts != (uint64_t)p * n)
        WRONG(.expected = kit_text("%u calls of put(), for %u passes",
                                   p * n, p),
              .found = kit_text("%ju", (uintmax_t)notes->puts),
              .cause = puts_cause(records, n));
    if (notes->gets > (uint64_t)(p + 1) * n)
        WRONG(.expected =
                  kit_text("at most %u calls of get()", (p + 1) * n),
              .found = kit_text("%ju", (uintmax_t)notes->gets),
              .cause = gets_cause(n, p));
    kit_next_case();
}

static void right(uint64_t seed)
{
    check(draw(1000, 0xffffffff, 0, seed));
    kit_next_case();
    check(draw(5000, 0xffffffff, 0, seed + 1));
}

static void equal_keys(uint64_t seed)
{
    check(draw(500, 0x80010402, 0, seed));
    kit_next_case();
    check(draw(500, 0x03000300, 0x00020001, seed));
}

static void few_records(uint64_t seed)
{
    for (uint32_t n = 0; n <= 8; n++) {
        check(draw(n, 0xffffffff, 0, seed + n));
        kit_next_case();
    }
}

static void calls(uint64_t seed)
{
    check_calls(draw(1000, 0xffffffff, 0, seed));
}

static void passes(uint64_t seed)
{
    check_calls(draw(1000, 0x00ff0000, 0, seed));
    check_calls(draw(1000, 0x000fffff, 0, seed));
    check_calls(draw(1000, 0x0000ff00, 0x37000000, seed));
}

static void no_pass(uint64_t seed)
{
    check_calls(draw(0, 0xffffffff, 0, seed));
    check_calls(draw(1, 0xffffffff, 0, seed));
    check_calls(draw(1000, 0, 0x12345678, seed));
}

const struct kit_test kit_tests[] = {
    {"right", 1, "32-bit keys", right},
    {"equal-keys", 2, "equal keys stay in their order", equal_keys},
    {"few-records", 1, "from no record to eight", few_records},
    {"calls", 3, "all histograms from one reading", calls},
    {"passes", 2, "no pass for bytes in which all agree", passes},
    {"no-pass", 1, "nothing moves if nothing has to", no_pass},
    {0},
};
