//> Time an instruction that gathers
// AVX2 has one for four indices. Nanoseconds an element beside the loop
// in plain C, in order and at random. Without AVX2, both are the loop.
//
//     gathers [TRIALS]
#include "ch02-all-pairs/timing.h"
#include "ch06-pack-scan/portable.h"
#include "ch06-pack-scan/workload.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>
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
#else
#define gather portable_gather
#endif

//> Price the loop and the instruction
static void print_gathers(enum work work, size_t bytes, int trials)
{
    struct primitives instruction = portable_primitives;
    if (isa_present(AVX2))
        instruction.gather = gather;
    struct workload workload = workload_make(work, bytes);
    struct priced priced[] = {
        {.primitives = &portable_primitives, .workload = &workload},
        {.primitives = &instruction, .workload = &workload}};
    price_in_turn(trials, priced, 2);
    printf("%s_%zu\t%zu", work_names[work], bytes, bytes);
    print_summary(&priced[0].ns, 1);
    print_summary(&priced[1].ns, 1);
    puts("");
    workload_free(&workload);
}
//<

int main(int argc, char **argv)
{
    fail_as("gathers");
    int trials = argument(argc, argv, 1, "TRIALS", 11, 1, MANY);
    report_provenance(stdout);
    puts("name\tbytes\tloop_ns\tloop_ns_q1\tloop_ns_q3"
         "\tinstruction_ns\tinstruction_ns_q1\tinstruction_ns_q3");
    for (size_t bytes = 1 << 14; bytes <= 1 << 22; bytes *= 16) {
        print_gathers(GATHER_IN_ORDER, bytes, trials);
        print_gathers(GATHER_AT_RANDOM, bytes, trials);
    }
    return 0;
}
//<
