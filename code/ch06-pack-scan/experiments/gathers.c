// Time the instructions that gather and scatter.
// AVX2 has one for four indices, AVX-512 for eight, and another that
// scatters. Nanoseconds an element beside the loop in plain C, in order
// and at random.
//     gathers [TRIALS]
#include "ch06-pack-scan/experiments/workload.h"
#include "ch06-pack-scan/primitives.h"
#ifdef HAVE_X86_VECTORS
#include <immintrin.h>

//> Gather four at a time
// The instruction takes indices for signed numbers: 32 bits would not
// do.
USE_AVX2
static void gather(double *to, const double *from,
                   const uint32_t *index, uint32_t n)
{
    uint32_t whole = n / 4 * 4;
    for (uint32_t i = 0; i < whole; i += 4) {
        __m256i four = _mm256_cvtepu32_epi64(
            _mm_loadu_si128((const __m128i *)(index + i)));
        _mm256_storeu_pd(to + i, _mm256_i64gather_pd(from, four, 8));
    }
    for (uint32_t i = whole; i < n; i++)
        to[i] = from[index[i]];
}
//<

// The instructions of AVX-512, for eight indices.
USE_AVX512
static void gather_eight(double *to, const double *from,
                         const uint32_t *index, uint32_t n)
{
    uint32_t whole = n / 8 * 8;
    for (uint32_t i = 0; i < whole; i += 8) {
        __m512i eight = _mm512_cvtepu32_epi64(
            _mm256_loadu_si256((const __m256i *)(index + i)));
        _mm512_storeu_pd(to + i, _mm512_i64gather_pd(eight, from, 8));
    }
    for (uint32_t i = whole; i < n; i++)
        to[i] = from[index[i]];
}

USE_AVX512
static void scatter_eight(double *to, const double *from,
                          const uint32_t *index, uint32_t n)
{
    uint32_t whole = n / 8 * 8;
    for (uint32_t i = 0; i < whole; i += 8) {
        __m512i eight = _mm512_cvtepu32_epi64(
            _mm256_loadu_si256((const __m256i *)(index + i)));
        _mm512_i64scatter_pd(to, eight, _mm512_loadu_pd(from + i), 8);
    }
    for (uint32_t i = whole; i < n; i++)
        to[index[i]] = from[i];
}
#else
#define gather portable_gather
#define gather_eight portable_gather
#define scatter_eight portable_scatter
#endif

// Price the loop and the instructions; where the processor lacks one,
// the loop stands for it.
static void print_routes(enum work work, size_t bytes, int trials)
{
    struct primitives avx2 = portable_primitives, avx512 = avx2;
    if (isa_present(AVX2))
        avx2.gather = gather;
    if (isa_present(AVX512)) {
        avx512.gather = gather_eight;
        avx512.scatter = scatter_eight;
    }
    const struct primitives *const tables[] = {&portable_primitives,
                                               &avx2, &avx512};
    struct summary ns[3];
    price_work(work, bytes, trials, tables, 3, ns);
    row_begin("%s_%zu\t%zu", work_names[work], bytes, bytes);
    for (int k = 0; k < 3; k++)
        row_times(&ns[k], 1);
    row_end();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    int trials = parameter(&e, "TRIALS", 11, 1, MANY);
    print_header(&e,
                 "name bytes loop_ns:3 instruction_ns:3 avx512_ns:3");
    for (size_t bytes = 1 << 14; bytes <= 1 << 22; bytes *= 16) {
        print_routes(GATHER_IN_ORDER, bytes, trials);
        print_routes(GATHER_AT_RANDOM, bytes, trials);
        print_routes(SCATTER_IN_ORDER, bytes, trials);
        print_routes(SCATTER_AT_RANDOM, bytes, trials);
    }
}
