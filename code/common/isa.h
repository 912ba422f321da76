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
//<
