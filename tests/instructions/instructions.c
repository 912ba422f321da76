// The vector code of the book with every instruction emulated in plain
// C, so that it is tested on machines without these instructions, too.
// Each source is compiled here once more under another name, with the
// <immintrin.h> of the folder emulated/.
#include "ch05-collisions/check_conflict.h"
#include "ch06-pack-scan/check_primitives.h"
#include "ch08-vector-spiral/check_spiral.h"
#include "ch09-row-spans/check_spans.h"
#include "ch10-furthest/check_furthest.h"

extern const struct primitives emulated_avx2_primitives;
extern const struct primitives emulated_avx512_primitives;
extern const struct spiral_kernels emulated_avx2_spiral,
    emulated_avx512_spiral;

extern const struct span_kernels emulated_avx2_spans,
    emulated_avx512_spans;
batch_kernel emulated_avx2_furthest, emulated_avx512_furthest;

void emulated_conflict_count(const uint32_t *cell_id, uint32_t n,
                             uint32_t *count);
void emulated_conflict_place(const uint32_t *cell_id, uint32_t n,
                             uint32_t *next, uint32_t *point);

static void conflict_detection_emulated(void)
{
    check_conflict(emulated_conflict_count, emulated_conflict_place);
}

static void avx2_primitives_emulated(void)
{
    check_primitives(&emulated_avx2_primitives, "emulated avx2");
    check_far(&emulated_avx2_primitives, "emulated avx2");
}

static void avx512_primitives_emulated(void)
{
    check_primitives(&emulated_avx512_primitives, "emulated avx512");
    check_far(&emulated_avx512_primitives, "emulated avx512");
}

// Between the kernels, the plain primitives do.
static void spiral_emulated(void)
{
    struct spiral_kernels kernels = emulated_avx2_spiral;
    kernels.isa = PORTABLE;
    check_spiral(&kernels, "emulated avx2");
    kernels = emulated_avx512_spiral;
    kernels.isa = PORTABLE;
    check_spiral(&kernels, "emulated avx512");
}

static void avx2_spans_emulated(void)
{
    check_spans(&emulated_avx2_spans);
}

static void avx512_spans_emulated(void)
{
    check_spans(&emulated_avx512_spans);
}

static void furthest_emulated(void)
{
    check_furthest(emulated_avx2_furthest, &emulated_avx2_spans);
    check_furthest(emulated_avx512_furthest, &emulated_avx512_spans);
}

int main(void)
{
    return RUN_TESTS("instructions", TEST(conflict_detection_emulated),
                     TEST(avx2_primitives_emulated),
                     TEST(avx512_primitives_emulated),
                     TEST(spiral_emulated), TEST(avx2_spans_emulated),
                     TEST(avx512_spans_emulated),
                     TEST(furthest_emulated));
}
