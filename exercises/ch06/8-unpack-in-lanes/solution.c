// Eight lanes take the next eight survivors and hand each to the lane
// of its flag: lane i wants the survivor whose number is how many flags
// are set before it. Where there are only four lanes, a table says so.
#include "exercise.h"

//- solution
#if defined __AVX2__ && defined __BMI2__
#include <immintrin.h>

// The bytes 0 to 7 go to the places of the flags, in order.
static void unpack_eight(uint32_t flags, const uint32_t *from,
                         uint32_t *to, __m256i holes)
{
    const uint64_t marks = _pdep_u64(flags, 0x0101010101010101) * 255;
    const uint64_t ranks = _pdep_u64(0x0706050403020100, marks);
    const __m256i order =
        _mm256_cvtepu8_epi32(_mm_cvtsi64_si128((long long)ranks));
    const __m256i wanted =
        _mm256_cvtepi8_epi32(_mm_cvtsi64_si128((long long)marks));
    const __m256i next =
        _mm256_loadu_si256((const __m256i *)(const void *)from);
    const __m256i moved = _mm256_permutevar8x32_epi32(next, order);
    _mm256_storeu_si256((__m256i *)(void *)to,
                        _mm256_blendv_epi8(holes, moved, wanted));
}

void unpack(uint32_t n, const uint8_t *keep, const uint32_t *from,
            uint32_t *to, uint32_t hole)
{
    const __m256i holes = _mm256_set1_epi32((int)hole);
    for (uint32_t i = 0; i < n; i += 8) {
        const uint32_t flags = keep[i / 8];
        unpack_eight(flags, from, to + i, holes);
        from += __builtin_popcount(flags);
    }
}

#elif defined __ARM_NEON && defined __aarch64__
#include <arm_neon.h>

// For four flags, the bytes of the survivors that the lanes want; 255
// is none.
static void make_table(uint8_t (*bytes)[16])
{
    for (uint32_t flags = 0; flags < 16; flags++) {
        uint8_t rank = 0;
        for (uint32_t b = 0; b < 16; b++) {
            const uint32_t set = flags >> b / 4 & 1;
            bytes[flags][b] = set ? 4 * rank + b % 4 : 255;
            rank += set && b % 4 == 3;
        }
    }
}

void unpack(uint32_t n, const uint8_t *keep, const uint32_t *from,
            uint32_t *to, uint32_t hole)
{
    uint8_t bytes[16][16];
    make_table(bytes);
    const uint8x16_t holes = vreinterpretq_u8_u32(vdupq_n_u32(hole));
    for (uint32_t i = 0; i < n; i += 4) {
        const uint32_t flags = keep[i / 8] >> i % 8 & 15;
        const uint8x16_t next = vreinterpretq_u8_u32(vld1q_u32(from));
        const uint8x16_t moved =
            vqtbx1q_u8(holes, next, vld1q_u8(bytes[flags]));
        vst1q_u32(to + i, vreinterpretq_u32_u8(moved));
        from += __builtin_popcount(flags);
    }
}

#else
// In plain C, where neither is there.
void unpack(uint32_t n, const uint8_t *keep, const uint32_t *from,
            uint32_t *to, uint32_t hole)
{
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t set = keep[i / 8] >> i % 8 & 1;
        to[i] = set ? *from : hole;
        from += set;
    }
}
#endif
//- starter
// void unpack(uint32_t n, const uint8_t *keep, const uint32_t *from,
//             uint32_t *to, uint32_t hole)
// {
// #if defined __AVX2__
//     // Your turn: #include <immintrin.h>, and eight lanes.
// #elif defined __ARM_NEON
//     // Or #include <arm_neon.h>, and four lanes.
// #endif
//     // So far all survive.
//     (void)keep, (void)hole;
//     for (uint32_t i = 0; i < n; i++)
//         to[i] = from[i % SPARE];
// }
//- end
