//> Choose the kernels of the spiral
// One constant structure for each instruction set; a processor without
// vector instructions of x86 has only the portable one.
#include "ch08-vector-spiral/spiral_kernels.h"
#include "ch08-vector-spiral/fused.h"
#include <assert.h>

static const struct spiral_kernels *const tables[ISA_COUNT] = {
    [PORTABLE] = &portable_spiral,
#ifdef HAVE_X86_VECTORS
    [AVX2] = &avx2_spiral,
    [AVX512] = &avx512_spiral,
#endif
};

const struct spiral_kernels *spiral_kernels(enum isa isa)
{
    assert(isa_present(isa) && "its instructions would be illegal");
    return tables[isa];
}
//<
