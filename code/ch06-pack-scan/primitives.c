//> Choose the primitives
// The tables of functions, one for each instruction set. A processor
// without vector instructions of x86 has only the portable one.
#include "ch06-pack-scan/primitives.h"
#include "ch06-pack-scan/avx2.h"
#include "ch06-pack-scan/avx512.h"
#include "ch06-pack-scan/portable.h"
#include <assert.h>

//> Look up the table of an instruction set
static const struct primitives *const tables[ISA_COUNT] = {
    [PORTABLE] = &portable_primitives,
#ifdef HAVE_X86_VECTORS
    [AVX2] = &avx2_primitives,
    [AVX512] = &avx512_primitives,
#endif
};

const struct primitives *primitives(enum isa isa)
{
    assert(isa_present(isa) && "its instructions would be illegal");
    return tables[isa];
}
//<
//<
