// Tests of unpack in lanes: the answers, and the time, beside that of a
// loop that takes one number after the other.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

static uint32_t n, hole, survivors;
static uint8_t *keep;
static uint32_t *from, *to;

static uint32_t flag(uint32_t i)
{
    return keep[i / 8] >> i % 8 & 1;
}

// to ends where a page ends, so it begins at a multiple of 32 bytes; if
// it shall not, there is an element behind it.
static void make_output(bool aligned)
{
    to = kit_output("to", aligned ? n : n + 1, sizeof *to);
    kit_given("%u flags, %u of them set%s", n, survivors,
              aligned ? "" : ", to not at a multiple of 32 bytes");
}

static void prepare(uint32_t count, double share, uint64_t seed)
{
    struct random random = {seed};
    n = count;
    hole = (uint32_t)random_bits(&random);
    survivors = 0;
    keep = kit_input("keep", n / 8, sizeof *keep);
    for (uint32_t b = 0; b < n / 8; b++) {
        keep[b] = 0;
        for (int k = 0; k < 8; k++)
            keep[b] |= (random_uniform(&random) < share) << k;
        survivors += __builtin_popcount(keep[b]);
    }
    from = kit_input("from", survivors + SPARE, sizeof *from);
    for (uint32_t k = 0; k < survivors + SPARE; k++)
        from[k] = 1000 + k;
    make_output(true);
}

// Where the found number stands among the survivors.
static const char *cause(uint32_t i, uint32_t right)
{
    const uint32_t found = to[i];
    if (flag(i) && found == hole)
        return "Its flag is set. Flag i is bit i % 8 of its byte, from "
               "the lowest bit on.";
    if (!flag(i) && found != hole)
        return "Its flag is not set: the hole belongs there. Flag i is "
               "bit i % 8 of its byte, from the lowest bit on.";
    if (found >= 1000 && found < 1000 + survivors + SPARE)
        return found < right
                   ? "This survivor has had its place before. Does "
                     "from move on by as many as flags were set?"
                   : "Survivors were left out. Does from move on by as "
                     "many as flags were set, and by no more?";
    return "This is neither a survivor nor the hole: was it ever "
           "written?";
}

static void check(void)
{
    CALL(STUDENT(unpack)(n, keep, from, to, hole));
    uint32_t next = 0;
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t right = flag(i) ? from[next++] : hole;
        if (to[i] != right)
            WRONG(.where = kit_text("to[%u], flag %u in the byte %02x",
                                    i, flag(i), keep[i / 8]),
                  .expected = flag(i) ? kit_text("from[%u], %u",
                                                 next - 1, right)
                                      : kit_text("the hole, %u", right),
                  .found = kit_text("%u", to[i]),
                  .cause = cause(i, right));
    }
    kit_next_case();
}

static void sparse(uint64_t seed)
{
    static const double shares[] = {0, 0.05, 0.95, 1};
    for (int k = 0; k < 4; k++) {
        prepare(0, shares[k], seed);
        check();
        prepare(64, shares[k], seed + k);
        check();
        prepare(4000, shares[k], seed + k);
        check();
    }
}

static void any(uint64_t seed)
{
    for (uint32_t bytes = 1; bytes <= 40; bytes++) {
        prepare(8 * bytes, 0.5, seed + bytes);
        check();
    }
    prepare(800, 0.5, seed);
    make_output(false);
    check();
}

static void bytes(uint64_t seed)
{
    prepare(8 * 256, 0.5, seed);
    kit_next_case();
    n = 8 * 256;
    keep = kit_input("keep", 256, sizeof *keep);
    for (uint32_t b = 0; b < 256; b++)
        keep[b] = b;
    survivors = 4 * 256;
    from = kit_input("from", survivors + SPARE, sizeof *from);
    for (uint32_t k = 0; k < survivors + SPARE; k++)
        from[k] = 1000 + k;
    to = kit_output("to", n, sizeof *to);
    kit_given("the flags of all bytes, 0 to 255");
    check();
}

// ---- time ----------------------------------------------------------

#if defined __AVX2__ || (defined __ARM_NEON && defined __aarch64__)
static const bool has_lanes = true;
#else
static const bool has_lanes = false;
#endif

enum { TIMED = 1 << 13, REPEATS = 12000 };

static void theirs(void)
{
    const int repeats = kit_is_sanitized() ? 1 : REPEATS;
    CALL(for (int r = 0; r < repeats; r++)
             STUDENT(unpack)(n, keep, from, to, hole));
}

static void one_by_one(void)
{
    CALL(for (int r = 0; r < REPEATS; r++) {
        const uint32_t *next = from;
        for (uint32_t i = 0; i < n; i++) {
            const uint32_t set = flag(i);
            to[i] = set ? *next : hole;
            next += set;
        }
    });
}

static void in_time(uint64_t seed)
{
    any(seed);
    if (!has_lanes && !kit_is_sanitized())
        kit_not_graded("this machine has neither AVX2 nor NEON, or the "
                       "program is not compiled for it");
    prepare(TIMED, 0.5, seed);
    double ratio =
        kit_race((struct kit_race){theirs, one_by_one, .cores = 1});
    kit_bands(
        ratio,
        (struct kit_band[]){{0.5, 6}, {0.67, 4}, {0.83, 2}, {0, 0}},
        (struct kit_fault){
            .expected = "half of the time of a loop over one number "
                        "after the other",
            .found = kit_text("%.2f of it", ratio),
            .cause = "A permutation, by intrinsics, hands several "
                     "survivors to their lanes at once; no compiler "
                     "finds it. If you have one: what else is made "
                     "lane by lane in each turn, the order or the "
                     "mask?"});
}

const struct kit_test kit_tests[] = {
    {"sparse", 1, "no flags, few flags, all flags", sparse},
    {"any", 2, "8 to 320 flags", any},
    {"bytes", 1, "all sets of eight flags", bytes},
    {"time", 6, "twice as fast as one by one", in_time},
    {0},
};
