// The checks of chapter 6's primitives, for a table of them: every
// length from 0 to 300, every alignment, in place where that is
// promised, against plain loops written here; and not a number beside
// the arrays may change. For tests/instructions, too.
#pragma once
#include "ch06-pack-scan/primitives.h"
#include "common/random.h"
#include "harness.h"
#include <string.h>
#include <sys/mman.h>

// Arrays of up to LONGEST, ALIGNMENTS ways, with as much on either side
// as a vector could spoil.
enum { LONGEST = 300, ALIGNMENTS = 16, MARGIN = 32 };
enum { AREA = MARGIN + ALIGNMENTS + LONGEST + MARGIN };

struct area32 {
    uint32_t all[AREA];
};

struct area {
    double all[AREA];
};

static inline void fill32(struct area32 *area, struct random *random)
{
    for (int i = 0; i < AREA; i++)
        area->all[i] = (uint32_t)random_bits(random);
}

static inline void fill(struct area *area, struct random *random)
{
    for (int i = 0; i < AREA; i++)
        area->all[i] = random_uniform(random) - 0.5;
}

// What a check is about, for its message.
struct trying {
    const char *isa, *what;
    uint32_t n;
    int alignment;
};

// Reports the first difference only, by its place in the array.
static inline bool same32(const struct area32 *expected,
                          const struct area32 *found,
                          struct trying trying)
{
    int i = 0;
    while (i < AREA && expected->all[i] == found->all[i])
        i++;
    return i == AREA ||
           CHECK_INT(expected->all[i], found->all[i],
                     "%s, %s of %u, alignment %d: number %d",
                     trying.isa, trying.what, trying.n,
                     trying.alignment, i - MARGIN - trying.alignment);
}

static inline bool same(const struct area *expected,
                        const struct area *found, struct trying trying)
{
    int i = 0;
    while (i < AREA && expected->all[i] == found->all[i])
        i++;
    return i == AREA ||
           CHECK_DOUBLE(expected->all[i], found->all[i],
                        "%s, %s of %u, alignment %d: number %d",
                        trying.isa, trying.what, trying.n,
                        trying.alignment,
                        i - MARGIN - trying.alignment);
}

static inline void check_add(const struct primitives *p,
                             struct trying t, struct random *random)
{
    int at = MARGIN + t.alignment, from = MARGIN + t.alignment * 7 % 16;
    struct area a, b, right, found;
    fill(&a, random);
    fill(&b, random);
    fill(&found, random);
    right = found;
    for (uint32_t i = 0; i < t.n; i++)
        right.all[at + i] = a.all[from + i] + b.all[at + i];
    p->add(found.all + at, a.all + from, b.all + at, t.n);
    t.what = "add";
    same(&right, &found, t);
    right = found = b;
    for (uint32_t i = 0; i < t.n; i++)
        right.all[at + i] = a.all[from + i] + b.all[at + i];
    p->add(found.all + at, a.all + from, found.all + at, t.n);
    t.what = "add in place";
    same(&right, &found, t);
}

// Gathers, which may be in place if all indices lead ahead.
static inline void check_gather(const struct primitives *p,
                                struct trying t, struct random *random)
{
    int at = MARGIN + t.alignment, from = MARGIN + t.alignment * 7 % 16;
    struct area a, right, found;
    struct area32 a32, right32, found32, index;
    fill(&a, random);
    fill(&found, random);
    fill32(&a32, random);
    fill32(&found32, random);
    fill32(&index, random);
    right = found;
    right32 = found32;
    for (uint32_t i = 0; i < t.n; i++) {
        uint32_t j = index.all[at + i] %= t.n;
        right.all[at + i] = a.all[from + j];
        right32.all[at + i] = a32.all[from + j];
    }
    p->gather(found.all + at, a.all + from, index.all + at, t.n);
    p->gather32(found32.all + at, a32.all + from, index.all + at, t.n);
    t.what = "gather";
    same(&right, &found, t);
    t.what = "gather32";
    same32(&right32, &found32, t);

    right = found = a;
    right32 = found32 = a32;
    for (uint32_t i = 0; i < t.n; i++) {
        uint32_t j = i + random_bits(random) % (t.n - i);
        index.all[at + i] = j;
        right.all[at + i] = a.all[at + j];
        right32.all[at + i] = a32.all[at + j];
    }
    p->gather(found.all + at, found.all + at, index.all + at, t.n);
    p->gather32(found32.all + at, found32.all + at, index.all + at,
                t.n);
    t.what = "gather in place";
    same(&right, &found, t);
    t.what = "gather32 in place";
    same32(&right32, &found32, t);
}

// Scatters to half as many places: most of them meet twice.
static inline void check_scatter(const struct primitives *p,
                                 struct trying t, struct random *random)
{
    int at = MARGIN + t.alignment, from = MARGIN + t.alignment * 7 % 16;
    struct area a, right, found;
    struct area32 a32, right32, found32, index;
    fill(&a, random);
    fill(&found, random);
    fill32(&a32, random);
    fill32(&found32, random);
    fill32(&index, random);
    right = found;
    right32 = found32;
    for (uint32_t i = 0; i < t.n; i++) {
        uint32_t j = index.all[at + i] %= t.n / 2 + 1;
        right.all[at + j] = a.all[from + i];
        right32.all[at + j] = a32.all[from + i];
    }
    p->scatter(found.all + at, a.all + from, index.all + at, t.n);
    p->scatter32(found32.all + at, a32.all + from, index.all + at, t.n);
    t.what = "scatter";
    same(&right, &found, t);
    t.what = "scatter32";
    same32(&right32, &found32, t);
}

static inline void check_scan(const struct primitives *p,
                              struct trying t, struct random *random)
{
    int at = MARGIN + t.alignment, from = MARGIN + t.alignment * 7 % 16;
    struct area32 a, right, found;
    fill32(&a, random);
    fill32(&found, random);
    right = found;
    uint32_t begin = (uint32_t)random_bits(random), sum = begin;
    for (uint32_t i = 0; i < t.n; i++) {
        right.all[at + i] = sum;
        sum += a.all[from + i];
    }
    uint32_t total = p->scan(found.all + at, a.all + from, t.n, begin);
    CHECK_INT(sum, total, "%s, total of %u", t.isa, t.n);
    t.what = "scan";
    same32(&right, &found, t);

    right = found = a;
    sum = begin;
    for (uint32_t i = 0; i < t.n; i++) {
        right.all[at + i] = sum;
        sum += a.all[at + i];
    }
    total = p->scan(found.all + at, found.all + at, t.n, begin);
    CHECK_INT(sum, total, "%s, total of %u in place", t.isa, t.n);
    t.what = "scan in place";
    same32(&right, &found, t);
}

// Packs; up to SPILL numbers behind the packed ones may be anything.
static inline void check_pack(const struct primitives *p,
                              struct trying t, double share,
                              struct random *random)
{
    int at = MARGIN + t.alignment, from = MARGIN + t.alignment * 7 % 16;
    uint8_t flags[AREA], *keep = flags + t.alignment;
    struct area32 a, before, right, found;
    fill32(&a, random);
    for (int i = 0; i < AREA; i++)
        flags[i] = random_uniform(random) < share;
    for (int in_place = 0; in_place <= 1; in_place++) {
        if (in_place) {
            from = at;
            before = a;
        } else {
            fill32(&before, random);
        }
        right = found = before;
        uint32_t kept = 0;
        for (uint32_t i = 0; i < t.n; i++)
            if (keep[i])
                right.all[at + kept++] = a.all[from + i];
        uint32_t *to = found.all + at;
        CHECK_INT(kept,
                  p->pack(to, in_place ? to : a.all + from, keep, t.n),
                  "%s, how many of %u are kept", t.isa, t.n);
        uint32_t spilt = kept + SPILL < t.n ? kept + SPILL : t.n;
        memcpy(to + kept, right.all + at + kept,
               (spilt - kept) * sizeof *to);
        t.what = in_place ? "pack in place" : "pack";
        same32(&right, &found, t);
    }
}

static inline void check_primitives(const struct primitives *p,
                                    const char *isa)
{
    for (uint32_t n = 0; n <= LONGEST; n++)
        for (int alignment = 0; alignment < ALIGNMENTS; alignment++) {
            uint64_t seed = n * 16 + alignment + 1;
            test_seed(seed);
            struct random random = {seed};
            struct trying trying = {isa, "", n, alignment};
            check_add(p, trying, &random);
            check_gather(p, trying, &random);
            check_scatter(p, trying, &random);
            check_scan(p, trying, &random);
            check_pack(p, trying, 0, &random);
            check_pack(p, trying, 0.1, &random);
            check_pack(p, trying, 0.5, &random);
            check_pack(p, trying, 0.9, &random);
            check_pack(p, trying, 1, &random);
        }
}

// Routes through indices of all 32 bits, which some instructions take
// for signed numbers. The array is 32 GB of addresses and a few pages
// of memory; where so many are not to be had, nothing is checked.
static inline void check_far(const struct primitives *p,
                             const char *isa)
{
    const size_t size = sizeof(double) << 32;
    void *all =
        mmap(NULL, size, PROT_READ | PROT_WRITE,
             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (all == MAP_FAILED)
        return;
    const uint32_t index[] = {0,          0x7fffffff, 0x80000000,
                              0xffffffff, 7,          0xfffffff8,
                              0x80000001, 0xc0000000, 0x40000000};
    enum { PLACES = sizeof index / sizeof *index };
    double from[PLACES], to[PLACES];
    uint32_t from32[PLACES], to32[PLACES];
    for (int i = 0; i < PLACES; i++)
        from[i] = from32[i] = i + 1;
    p->scatter(all, from, index, PLACES);
    p->gather(to, all, index, PLACES);
    for (int i = 0; i < PLACES; i++)
        CHECK_DOUBLE(from[i], to[i], "%s, through index %u", isa,
                     index[i]);
    p->scatter32(all, from32, index, PLACES);
    p->gather32(to32, all, index, PLACES);
    for (int i = 0; i < PLACES; i++)
        CHECK_INT(from32[i], to32[i], "%s, 32 bits, through index %u",
                  isa, index[i]);
    munmap(all, size);
}
