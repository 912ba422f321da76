//> Choose the instruction set
// Asks the processor what it has and takes the most, or what NEAR_ISA
// names. AVX-512 stands for what the processors of 2017 and later have
// of it: F, CD, BW, DQ and VL.
#include "common/isa.h"
#include "common/fail.h"
#include <stdlib.h>
#include <string.h>

const char *const isa_names[] = {"portable", "avx2", "avx512"};

//> Ask the processor
bool isa_present(enum isa isa)
{
#ifdef __x86_64__
    __builtin_cpu_init();
    if (isa == AVX512)
        return isa_present(AVX2) && __builtin_cpu_supports("avx512f") &&
               __builtin_cpu_supports("avx512cd") &&
               __builtin_cpu_supports("avx512bw") &&
               __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
    if (isa == AVX2)
        return __builtin_cpu_supports("avx2") &&
               __builtin_cpu_supports("fma") &&
               __builtin_cpu_supports("bmi2");
#endif
    return isa == PORTABLE;
}
//<

//> Take what is asked for, or the most
enum isa isa_chosen(void)
{
    const char *name = getenv("NEAR_ISA");
    bool any = !name || !*name;
    for (int isa = ISA_COUNT - 1; isa >= 0; isa--) {
        bool wanted = any || strcmp(name, isa_names[isa]) == 0;
        if (wanted && isa_present(isa))
            return isa;
        if (wanted && !any)
            fail("NEAR_ISA: this processor has no %s", name);
    }
    fail("NEAR_ISA: expected portable, avx2 or avx512, found \"%s\"",
         name);
}
//<
//<
