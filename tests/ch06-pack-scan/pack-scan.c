// Pack and scan: the primitives of every instruction set that this
// machine has, and over threads; which instruction set is chosen; and
// escape times, packed and not.
#include "ch06-pack-scan/blocked.h"
#include "ch06-pack-scan/check_primitives.h"
#include "ch06-pack-scan/escape.h"
#include "common/fail.h"
#include "common/generate.h"
#include <stdio.h>
#include <stdlib.h>

static void every_instruction_set(void)
{
    for (int isa = 0; isa < ISA_COUNT; isa++)
        if (isa_present(isa)) {
            CHECK_INT(isa, primitives(isa)->isa, "the table for %s",
                      isa_names[isa]);
            check_primitives(primitives(isa), isa_names[isa]);
            check_far(primitives(isa), isa_names[isa]);
        }
}

// One length over threads: against the portable scan and pack, with
// guards behind what is packed, where a vector might spill.
static void check_blocked(const struct primitives *p, uint32_t n,
                          uint32_t block, int threads, double share)
{
    const struct primitives *plain = primitives(PORTABLE);
    const struct rounds rounds = {p, block, threads};
    enum { GUARDS = SPILL };
    uint32_t *from = allocate(n + GUARDS, sizeof *from);
    uint32_t *right = allocate(n + GUARDS, sizeof *right);
    uint32_t *found = allocate(n + GUARDS, sizeof *found);
    uint8_t *keep = allocate(n, sizeof *keep);
    struct random random = {n + block + threads};
    test_seed(n + block + threads);
    for (uint32_t i = 0; i < n + GUARDS; i++) {
        from[i] = (uint32_t)random_bits(&random);
        right[i] = found[i] = ~0u;
    }
    for (uint32_t i = 0; i < n; i++)
        keep[i] = random_uniform(&random) < share;

    uint32_t kept = plain->pack(right, from, keep, n);
    for (uint32_t i = kept; i < n + GUARDS; i++)
        right[i] = ~0u; // over threads, nothing may spill
    CHECK_INT(kept, pack_blocked(&rounds, found, from, keep, n),
              "%s, %u in blocks of %u, %d threads: kept",
              isa_names[p->isa], n, block, threads);
    uint32_t i = 0;
    while (i < n + GUARDS && right[i] == found[i])
        i++;
    if (i < n + GUARDS)
        CHECK_INT(right[i], found[i],
                  "%s, pack of %u in blocks of %u, %d threads: %u",
                  isa_names[p->isa], n, block, threads, i);

    uint32_t total = plain->scan(right, from, n, 42);
    memcpy(right + n, from + n, GUARDS * sizeof *right);
    CHECK_INT(total, scan_blocked(&rounds, from, from, n, 42),
              "%s, %u in blocks of %u, %d threads: total",
              isa_names[p->isa], n, block, threads);
    for (i = 0; i < n + GUARDS && right[i] == from[i];)
        i++;
    if (i < n + GUARDS)
        CHECK_INT(right[i], from[i],
                  "%s, scan of %u in blocks of %u, %d threads: %u",
                  isa_names[p->isa], n, block, threads, i);
    free(keep);
    free(found);
    free(right);
    free(from);
}

static void over_threads(void)
{
    static const uint32_t lengths[] = {0,  1,   2,   15,   16,  17,
                                       31, 100, 255, 1000, 4099};
    static const uint32_t blocks[] = {1, 7, 64, 333, 1u << 31};
    for (int isa = 0; isa < ISA_COUNT; isa++)
        for (int l = 0; isa_present(isa) && l < 11; l++)
            for (int b = 0; b < 5; b++)
                for (int threads = 1; threads <= 5; threads++) {
                    if (lengths[l] / blocks[b] > 300)
                        continue; // as many barriers
                    const double share = (l + b + threads) % 5 * 0.25;
                    check_blocked(primitives(isa), lengths[l],
                                  blocks[b], threads, share);
                }
}

// NEAR_ISA is the user's: names that are none, and instruction sets
// that are not there, are refused in one sentence.
static void choose(void *name)
{
    setenv("NEAR_ISA", name, 1);
    isa_chosen();
}

static void instruction_set_by_name(void)
{
    char sentence[100];
    for (int isa = 0; isa < ISA_COUNT; isa++) {
        const char *name = isa_names[isa];
        if (isa_present(isa)) {
            setenv("NEAR_ISA", name, 1);
            CHECK_INT(isa, isa_chosen(), "asked for %s", name);
        } else {
            snprintf(sentence, sizeof sentence,
                     "NEAR_ISA: this processor has no %s", name);
            CHECK_FAILS(sentence, choose, (void *)name, "asked for %s",
                        name);
        }
    }
    CHECK_FAILS("NEAR_ISA: expected portable, avx2 or avx512, found "
                "\"mmx\"",
                choose, "mmx", "asked for what is none");
    setenv("NEAR_ISA", "", 1);
    CHECK(isa_present(isa_chosen()), "asked for nothing");
    unsetenv("NEAR_ISA");
    enum isa most = isa_chosen();
    for (int isa = most + 1; isa < ISA_COUNT; isa++)
        CHECK(!isa_present(isa), "%s was not chosen", isa_names[isa]);
}

// A point at a time, as anybody would write it.
static double escape_plainly(double cx, double cy, uint32_t limit)
{
    double x = 0, y = 0;
    uint32_t k = 0;
    while (k < limit && x * x + y * y <= 16) {
        double next = x * x - y * y + cx;
        y = x * y + x * y + cy;
        x = next;
        k++;
    }
    return k;
}

static void escapes(void)
{
    enum { LIMIT = 150 };
    struct points c = generate(find_distribution("uniform"), 3000, 6);
    test_seed(6);
    for (uint32_t i = 0; i < c.n; i++) {
        c.x[i] = 3 * c.x[i] - 2.2;
        c.y[i] = 2 * c.y[i] - 1;
    }
    c.x[0] = -2, c.y[0] = 0; // stays at 2 forever
    c.x[1] = 1e200, c.y[1] = -1e200;
    struct lanes lanes = lanes_allocate(c.n);
    double *steps = allocate(c.n, sizeof *steps);
    uint64_t sum = 0;
    for (uint32_t i = 0; i < c.n; i++)
        sum += escape_plainly(c.x[i], c.y[i], LIMIT);
    for (int isa = 0; isa < ISA_COUNT; isa++)
        for (uint32_t every = 0; every <= 160; every += every / 3 + 1) {
            if (!isa_present(isa))
                continue;
            uint64_t done =
                escape(primitives(isa), c, LIMIT, every, &lanes, steps);
            uint32_t i = 0;
            while (i < c.n &&
                   steps[i] == escape_plainly(c.x[i], c.y[i], LIMIT))
                i++;
            CHECK_INT(c.n, i, "%s, packed every %u: first wrong point",
                      isa_names[isa], every);
            if (every == 1)
                CHECK_INT(sum, done, "%s, steps packed every time",
                          isa_names[isa]);
            if (every == 0 || every >= LIMIT)
                CHECK_INT(c.n * LIMIT, done, "%s, steps never packed",
                          isa_names[isa]);
        }
    struct points none = {0, c.x, c.y};
    CHECK_INT(
        0, escape(primitives(PORTABLE), none, LIMIT, 1, &lanes, steps),
        "steps of no points");
    free(steps);
    lanes_free(&lanes);
    points_free(&c);
}

// The one that forks comes first, before there are threads.
int main(void)
{
    return RUN_TESTS("ch06-pack-scan", TEST(instruction_set_by_name),
                     TEST(every_instruction_set), TEST(over_threads),
                     TEST(escapes));
}
