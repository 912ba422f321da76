//> Declare the instruction sets
// Which vector instructions to use, found out when the program runs:
// the most that the processor has, or what NEAR_ISA asks for. The
// portable way, plain C, always exists.
#pragma once
#include <stdbool.h>

enum isa { PORTABLE, AVX2, AVX512 };

// The names that NEAR_ISA takes: "portable", "avx2", "avx512".
extern const char *const isa_names[];
enum { ISA_COUNT = 3 };

// Whether this processor and its operating system have it.
bool isa_present(enum isa isa);

// The one to use. Fails if NEAR_ISA names none, or one that is not
// present.
enum isa isa_chosen(void);

//> Let a function use an instruction set
// Code for an instruction set is compiled wherever it can be, whatever
// the rest is compiled for, and called only where it can run. With
// EMULATED every instruction is a function in plain C, on any machine:
// so tests/instructions tests what the machine at hand lacks.
#if defined __x86_64__ && !defined EMULATED
#define USE_AVX2 __attribute__((target("avx2,fma,bmi2")))
#define USE_AVX512                                                   \
    __attribute__((target("avx2,fma,bmi2,avx512f,avx512cd,avx512bw," \
                          "avx512dq,avx512vl")))
#else
#define USE_AVX2
#define USE_AVX512
#endif
#if defined __x86_64__ || defined EMULATED
#define HAVE_X86_VECTORS
#endif
//<

// What there is for each instruction set, as an array of ISA_COUNT.
#ifdef HAVE_X86_VECTORS
#define FOR_EACH_ISA(portable, avx2, avx512)                          \
    {                                                                 \
        [PORTABLE] = (portable), [AVX2] = (avx2), [AVX512] = (avx512) \
    }
#else
#define FOR_EACH_ISA(portable, avx2, avx512) \
    {                                        \
        [PORTABLE] = (portable)              \
    }
#endif
//<
